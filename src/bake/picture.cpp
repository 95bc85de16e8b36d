#include "bake/picture.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <png.h>

#include <csetjmp>
#include <exception>

namespace hn {
namespace {

// The state of libpng's callbacks.
struct PngSink {
  std::string bytes;
  std::string problem;
};

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<PngSink*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), size);
}
void flush_nothing(png_structp) {}
[[noreturn]] void note_problem(png_structp png, png_const_charp message) {
  static_cast<PngSink*>(png_get_error_ptr(png))->problem = message;
  png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

class PngWriter {
 public:
  explicit PngWriter(PngSink& sink)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, note_problem, ignore_warning)),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (png_) png_set_write_fn(png_, &sink, append, flush_nothing);
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

  bool is_there() const { return info_ != nullptr; }

  // False if libpng has called note_problem. It jumps over this function, which therefore has nothing to destroy.
  bool write(const std::uint16_t* pixels, int width, int height, int colour, int samples, png_textp texts, int count) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16, colour,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // The last bits of noise do not pack. The usual level 6 makes nothing smaller, and takes several times as long.
    png_set_compression_level(png_, 3);
    png_set_text(png_, info_, texts, count);
    png_write_info(png_, info_);
    png_set_swap(png_);  // ours are little-endian
    for (int y = 0; y < height; ++y) {
      const std::uint16_t* const row = pixels + static_cast<std::ptrdiff_t>(y) * width * samples;
      png_write_row(png_, reinterpret_cast<png_const_bytep>(row));
    }
    png_write_end(png_, info_);
    return true;
  }

 private:
  png_structp png_;
  png_infop info_;
};

int colour_of(std::size_t channels) {
  if (channels == 1) return PNG_COLOR_TYPE_GRAY;
  return channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

}  // namespace

Result<std::string> png_16(std::span<const Channel<std::uint16_t>> channels, int width, int height,
                           const Texts& texts) {
  const std::size_t samples = channels.size() == 2 ? 3 : channels.size();
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::uint16_t> pixels(size * samples);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t i = 0; i < size; ++i) pixels[i * samples + c] = channels[c].values[i];
  }
  std::vector<png_text> entries;
  for (const auto& [name, text] : texts) {
    png_text entry{};
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(name.c_str());  // libpng copies both
    entry.text = const_cast<char*>(text.c_str());
    entry.text_length = text.size();
    entries.push_back(entry);
  }
  PngSink sink;
  PngWriter writer(sink);
  if (!writer.is_there()) return fail("libpng could not be started");
  if (!writer.write(pixels.data(), width, height, colour_of(channels.size()), static_cast<int>(samples), entries.data(),
                    static_cast<int>(entries.size()))) {
    return fail(sink.problem);
  }
  return std::move(sink.bytes);
}

Result<std::string> exr(std::span<const Channel<float>> channels, int width, int height, const Texts& texts) {
  try {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : texts) header.insert(name, Imf::StringAttribute(text));
    Imf::FrameBuffer pixels;
    for (const Channel<float>& channel : channels) {
      header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
      auto* const data = reinterpret_cast<char*>(const_cast<float*>(channel.values.data()));  // it is only read
      pixels.insert(channel.name,
                    Imf::Slice(Imf::FLOAT, data, sizeof(float), sizeof(float) * static_cast<std::size_t>(width)));
    }
    Imf::StdOSStream stream;
    {
      Imf::OutputFile file(stream, header);
      file.setFrameBuffer(pixels);
      file.writePixels(height);
    }
    return stream.str();
  } catch (const std::exception& problem) {
    return fail(problem.what());
  }
}

}  // namespace hn
