// The cases that a browser can run, as data: what the page's suite.js reads. docs/reference/formats.md describes the
// JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/case.hpp"
#include "library/source.hpp"

namespace hn {

// WebGL2 takes GLSL ES 3.00 and 1.00.
inline constexpr LanguageSupport kWebGl2Languages = {
    .gl_version = 0, .es_version = 300, .gl130 = false, .bit_encoding = false};

// WebGPU takes WGSL.
LanguageSupport webgpu_languages();

// Why WebGL2, or WebGPU, or the page cannot run a case; empty if they can.
std::string unsupported_in_browser(const Case& test, Platform platform = Platform::opengl);

// Whether the page for any browser has a case: what WebGL2 runs, and of WebGPU, unless the page may be large, the bits
// of HN_FIXED, and the bugs.
bool is_on_page(const Case& test, bool thorough = false);

struct PageSuite {
  std::string json;
  // Why a case cannot be run, if so: its golden file or a source cannot be read. This is then its verdict.
  std::optional<std::string> defect;
};

// The JSON text of the cases. The page must be able to run each of them. The page posts what happens to report_to, if
// that is not empty. The platform is that without which the page cannot begin. whole: these are all default cases, and
// their results name the golden files.
PageSuite make_suite(const SourceSet& sources, const std::filesystem::path& golden, std::span<const Case> cases,
                     std::string_view report_to = {}, Platform platform = Platform::opengl, bool whole = false);

// The page with a suite in it, of the library or an edited one: one HTML file that needs nothing else, not even a
// server.
Result<std::string> web_page(const std::string& suite, const std::optional<EditedLibrary>& library = {});

}  // namespace hn
