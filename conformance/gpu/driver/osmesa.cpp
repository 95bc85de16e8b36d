#include <array>

#include "gpu/driver/driver.hpp"
#include "gpu/driver/library.hpp"

namespace hn {
namespace {

// From GL/osmesa.h, which is not needed to build: new releases of Mesa ship neither the header nor the library.
using OsmesaContext = struct OsmesaContextRecord*;
using CreateContextAttribs = OsmesaContext(const int*, OsmesaContext);
using MakeCurrent = GLboolean(OsmesaContext, void*, GLenum, GLsizei, GLsizei);
using DestroyContext = void(OsmesaContext);
using GetProcAddress = GLADapiproc(const char*);
constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

// OSMesa renders into memory of ours. We draw into framebuffer objects, so the smallest image will do.
constexpr int kSize = 16;

class OsmesaDriverContext final : public Context {
 public:
  explicit OsmesaDriverContext(Library library) : library_(library) {}
  ~OsmesaDriverContext() override {
    if (context_) library_.function<DestroyContext>("OSMesaDestroyContext")(context_);
  }

  Result<void> start() {
    auto* const create = library_.function<CreateContextAttribs>("OSMesaCreateContextAttribs");
    auto* const make_current = library_.function<MakeCurrent>("OSMesaMakeCurrent");
    auto* const get_proc_address = library_.function<GetProcAddress>("OSMesaGetProcAddress");
    if (!create || !make_current || !get_proc_address) return fail("this libOSMesa is older than Mesa 11.2");
    // Without a version, OSMesa gives 2.1. It has no way to ask for the highest.
    for (const auto& [major, minor] : kGlVersions) {
      const std::array attributes = {kFormat,       GL_RGBA, kProfile, kCoreProfile, kMajorVersion, major,
                                     kMinorVersion, minor,   0};
      context_ = create(attributes.data(), nullptr);
      if (context_) break;
    }
    if (!context_) return fail("libOSMesa does not create a core context of OpenGL 3.1 or later");
    if (!make_current(context_, image_.data(), GL_UNSIGNED_BYTE, kSize, kSize)) {
      return fail("OSMesaMakeCurrent failed");
    }
    return load_functions(get_proc_address);
  }

 private:
  Library library_;
  OsmesaContext context_ = nullptr;
  std::array<unsigned char, std::size_t{kSize} * kSize * 4> image_{};
};

}  // namespace

CreatedContext create_osmesa() {
  HN_TRY(auto library, Library::open({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}));
  auto context = std::make_unique<OsmesaDriverContext>(library);
  HN_DO(context->start());
  return context;
}

}  // namespace hn
