// Starting headless Chromium.
#pragma once

#include <string>

#include "web/browser.hpp"
#include "web/guarded_process.hpp"

namespace hn {

// On a page, with an empty profile in a folder that goes with it.
Result<GuardedProcess> start_chromium(const Browser& browser, const std::string& url);

}  // namespace hn
