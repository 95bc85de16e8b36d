// Tables as comma-separated values.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace hn {

// Fields are quoted as in RFC 4180, where they need it. Lines end in "\n", which every reader takes, so that a table
// is a text file like any other. Rows are written as they are, even with too many or too few fields.
std::string to_csv(std::span<const std::string> header, std::span<const std::vector<std::string>> rows);

// The facts about all rows of a record: where and how its numbers were measured.
using Facts = std::vector<std::pair<std::string, std::string>>;
// The table with the facts above it, as comments: "# date: 2026-01-02T03:04:05Z". tools/lib/measure/record.py reads it.
std::string to_record(const Facts& facts, std::span<const std::string> header,
                      std::span<const std::vector<std::string>> rows);

struct CsvRow {
  std::size_t line;                 // from 1
  std::vector<std::string> fields;  // without their quotes, and without blanks around them
};
// The header, and the rows below it. Lines end in "\n", "\r\n" or "\r". A byte order mark, empty lines and comments are
// skipped; a spreadsheet may have quoted a comment. Rows have as many fields as the header: empty ones behind these, as
// spreadsheets write them, are dropped. A quoted field stays in its line. An error names the path and the line, and if
// a field is wrong its number: "points.csv:3:1".
Result<std::vector<CsvRow>> parse_csv(std::string_view text, const std::string& path);

}  // namespace hn
