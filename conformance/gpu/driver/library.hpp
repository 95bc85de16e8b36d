// A shared library that is loaded at run time, so that the program starts where it is missing.
#pragma once

#include <dlfcn.h>
#include <fmt/format.h>

#include <initializer_list>
#include <string>

#include "base/result.hpp"

namespace hn {

class Library {
 public:
  // Takes the first of the names that can be loaded. It stays loaded until the process ends: Mesa starts threads and
  // registers exit handlers that must not outlive their code.
  static Result<Library> open(std::initializer_list<const char*> names) {
    std::string why;
    for (const char* name : names) {
      if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) return Library(handle);
      why += fmt::format("{}{}", why.empty() ? "" : "; ", dlerror());
    }
    return fail(why);
  }

  // A null pointer if the library has no such function.
  template <typename Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(handle_, name));
  }

 private:
  explicit Library(void* handle) : handle_(handle) {}
  void* handle_;
};

}  // namespace hn

// The function of a library that a header declares.
#define HN_FUNCTION(library, name) (library).function<decltype(name)>(#name)
