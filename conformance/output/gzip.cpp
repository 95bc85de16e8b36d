#include "output/gzip.hpp"

#include <zlib.h>

#include <limits>
#include <new>
#include <stdexcept>

namespace hn {

std::string to_gzip(std::string_view data) {
  if (data.size() > std::numeric_limits<uInt>::max()) throw std::length_error("to_gzip: more than 4 GiB");
  z_stream stream = {};
  constexpr int kGzip = 16;  // added to the bits of the window it selects gzip's header
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + kGzip, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::bad_alloc();
  }
  std::string packed(deflateBound(&stream, static_cast<uLong>(data.size())), '\0');
  // zlib reads through a pointer that is not const, and changes nothing there.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::logic_error("to_gzip: the bound of zlib did not suffice");
  return packed;
}

}  // namespace hn
