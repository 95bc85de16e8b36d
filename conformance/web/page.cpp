// The page: index.mustache with the modules and the suite inside.
#include "output/page.hpp"

#include <nlohmann/json.hpp>

#include "output/encoding.hpp"
#include "output/files.hpp"
#include "web/files.hpp"
#include "web/suite.hpp"

namespace hn {
namespace {

void replace_all(std::string& text, std::string_view old, std::string_view with) {
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size())) {
    text.replace(at, old.size(), with);
  }
}

// From a file: a browser loads no module but what is in the page; and a module there cannot name another relative to
// itself. So "./suite.js" becomes "hn/suite.js", which the page maps to the text of the module.
std::string import_map() {
  nlohmann::ordered_json imports;
  for (const auto& [name, module] : kWebFiles) {
    if (!name.ends_with(".js")) continue;
    std::string text(module);
    replace_all(text, "from \"./", "from \"hn/");
    imports["hn/" + std::string(name)] = "data:text/javascript;base64," + to_base64(text);
  }
  return nlohmann::ordered_json{{"imports", imports}}.dump();
}

}  // namespace

Result<std::string> web_page(const std::string& suite, const std::optional<EditedLibrary>& library) {
  return render_page(text_of(kWebFiles, "index.mustache"), {{"style", text_of(kOutputFiles, "style.mustache")},
                                                            {"library", library_text(library)},
                                                            {"suite", to_base64(to_gzip(suite))},
                                                            {"modules", import_map()}});
}

}  // namespace hn
