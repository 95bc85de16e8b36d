#include "output/base64.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace hn {

std::string to_base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  // The iterators look at a byte too many where the number of bytes is not a multiple of 3.
  constexpr std::size_t kGroup = 3;
  const std::size_t padding = (kGroup - bytes.size() % kGroup) % kGroup;
  std::string whole(bytes);
  whole.append(padding, '\0');
  using Iterator = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Iterator(whole.cbegin()), Iterator(whole.cend()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

}  // namespace hn
