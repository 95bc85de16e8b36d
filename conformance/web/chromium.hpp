// Starting headless Chromium.
#pragma once

#include <string>

#include "web/browser.hpp"
#include "web/guarded_process.hpp"

namespace hn {

// The path of its program; an error if there is none in PATH.
Result<std::string> find_program(const Browser& browser);

// Starts it on a page, with an empty profile in a folder that is removed with it.
Result<GuardedProcess> start_chromium(const Browser& browser, const std::string& url);

}  // namespace hn
