// Tables as comma-separated values.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hn {

// Fields are quoted as in RFC 4180, where they need it. Lines end in "\n", which every reader takes, so that a table
// is a text file like any other. Rows are written as they are, even with too many or too few fields.
std::string to_csv(std::span<const std::string> header, std::span<const std::vector<std::string>> rows);

// The facts about all rows of a record: where and how its numbers were measured.
using Facts = std::vector<std::pair<std::string, std::string>>;
// The table with the facts above it, as comments: "# date: 2026-01-02T03:04:05Z". tools/lib/measure/record.py reads it.
std::string to_record(const Facts& facts, std::span<const std::string> header,
                      std::span<const std::vector<std::string>> rows);

}  // namespace hn
