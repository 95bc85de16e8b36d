#include "base/csv.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace hn {
namespace {

void add_field(std::string& out, const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) {
    out += field;
    return;
  }
  out += '"';
  for (const char c : field) out.append(c == '"' ? 2 : 1, c);
  out += '"';
}

void add_row(std::string& out, std::span<const std::string> fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) out += ',';
    add_field(out, fields[i]);
  }
  // Readers skip an empty line; a row of one empty field shall be read.
  if (fields.size() == 1 && fields[0].empty()) out += "\"\"";
  out += '\n';
}

}  // namespace

std::string to_csv(std::span<const std::string> header, std::span<const std::vector<std::string>> rows) {
  std::string out;
  add_row(out, header);
  for (const std::vector<std::string>& row : rows) add_row(out, row);
  return out;
}

std::string to_record(const Facts& facts, std::span<const std::string> header,
                      std::span<const std::vector<std::string>> rows) {
  std::string out;
  for (const auto& [name, value] : facts) {
    std::string line = "# " + name + ": " + value;
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out += clean_text(line) + "\n";
  }
  return out + clean_text(to_csv(header, rows));
}

}  // namespace hn
