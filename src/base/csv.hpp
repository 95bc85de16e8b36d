// Tables as comma-separated values.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace hn {

// Fields are quoted as in RFC 4180, where they need it. Lines end in "\n", which every reader takes, so that a table
// is a text file like any other. Rows are written as they are, even with too many or too few fields.
std::string to_csv(std::span<const std::string> header, std::span<const std::vector<std::string>> rows);

}  // namespace hn
