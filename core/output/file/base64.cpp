#include "core/output/file/base64.h"

#include <openssl/evp.h>

#include "core/base/error.h"

namespace nilas::output {

void add_base64(std::span<const std::byte> bytes, std::string& text) {
  const std::size_t before = text.size(), length = 4 * ((bytes.size() + 2) / 3);
  text.resize(before + length + 1);  // OpenSSL appends a zero
  auto* out = reinterpret_cast<unsigned char*>(text.data() + before);
  EVP_EncodeBlock(out, reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.pop_back();
}

std::string from_base64(std::string_view text) {
  std::string bytes(text.size() / 4 * 3, '\0');
  const auto* in = reinterpret_cast<const unsigned char*>(text.data());
  auto* out = reinterpret_cast<unsigned char*>(bytes.data());
  if (text.size() % 4 != 0 || EVP_DecodeBlock(out, in, static_cast<int>(text.size())) < 0)
    throw InputError("is no base64 text");
  return bytes;
}

}  // namespace nilas::output
