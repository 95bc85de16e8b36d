#include "base/csv.hpp"

#include <fmt/format.h>

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

constexpr std::string_view kBlanks = " \t";

// The field at a place, which becomes the place of the comma behind it. An error completes "the field ...".
Result<std::string> field_at(std::string_view line, std::size_t& at) {
  at = std::min(line.find_first_not_of(kBlanks, at), line.size());
  if (!line.substr(at).starts_with('"')) {
    std::string_view field = line.substr(at, line.find(',', at) - at);
    at += field.size();
    return std::string(field.substr(0, field.find_last_not_of(kBlanks) + 1));
  }
  std::string field;
  for (++at;; ++at) {
    const auto end = line.find('"', at);
    if (end == line.npos) return fail("has a quote that its line does not close");
    field += line.substr(at, end - at);
    at = end + 1;
    if (!line.substr(at).starts_with('"')) break;
    field += '"';  // written twice within quotes
  }
  at = std::min(line.find_first_not_of(kBlanks, at), line.size());
  if (at == line.size() || line[at] == ',') return field;
  return fail(fmt::format("has {} behind its closing quote", in_quotes(line.substr(at, 1))));
}

Result<std::vector<std::string>> fields_of(std::string_view line, const std::string& place) {
  std::vector<std::string> fields;
  for (std::size_t at = 0;; ++at) {
    auto field = field_at(line, at);
    if (!field) return fail(fmt::format("{}:{}: the field {}", place, fields.size() + 1, field.error().message));
    fields.push_back(*std::move(field));
    if (at == line.size()) return fields;
  }
}

// Spreadsheets separate by semicolons in countries where numbers have commas.
std::string_view other_separator(std::string_view header) {
  if (header.find(',') != header.npos) return "";
  header = header.substr(0, header.find_last_not_of(kBlanks) + 1);
  return header.find(';') != header.npos ? "semicolons" : header.find('\t') != header.npos ? "tabs" : "";
}

bool is_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
         (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0'));
}

Result<void> add_line(std::vector<CsvRow>& rows, std::string_view line, std::size_t number, const std::string& path) {
  const auto first = line.find_first_not_of(" \t\"");
  if (line.find_first_not_of(kBlanks) == line.npos || (first != line.npos && line[first] == '#')) return {};
  const std::string place = fmt::format("{}:{}", path, number);
  if (line.find('\0') != line.npos) return fail(fmt::format("{}: a table must not contain NUL", place));
  const std::string_view other = rows.empty() ? other_separator(line) : "";
  if (!other.empty()) {
    return fail(
        fmt::format("{}: it has {} between its fields; write commas, and points in numbers: 0.5,0.25", place, other));
  }
  HN_TRY(auto fields, fields_of(line, place));
  const std::size_t wanted = rows.empty() ? 1 : rows.front().fields.size();
  while (fields.size() > wanted && fields.back().empty()) fields.pop_back();
  if (!rows.empty() && fields.size() != wanted) {
    return fail(fmt::format("{}: it has {} fields, and the header has {}{}", place, fields.size(), wanted,
                            fields.size() == 2 * wanted ? "; numbers have a point and no comma" : ""));
  }
  rows.push_back({number, std::move(fields)});
  return {};
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

Result<std::vector<CsvRow>> parse_csv(std::string_view text, const std::string& path) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (is_utf16(text)) {
    return fail(
        fmt::format("{}: it is UTF-16, as > in PowerShell 5 writes; write UTF-8: ... | Out-File -Encoding utf8", path));
  }
  std::vector<CsvRow> rows;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    HN_DO(add_line(rows, line, number, path));
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
  }
  if (rows.empty()) return fail(fmt::format("{}: it has no header", path));
  return rows;
}

}  // namespace hn
