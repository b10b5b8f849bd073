#include "secrets.hpp"

#include <cstdlib>
#include <regex>

namespace opal::postgis_store {
namespace {

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::string on_one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return std::regex_replace(text, std::regex("\\s*\n\\s*"), "; ");
}

}  // namespace

std::string without_secrets(std::string text) {
  const char* password = std::getenv("PGPASSWORD");
  if (password != nullptr && *password != '\0') replace_all(text, password, "***");
  text = std::regex_replace(text, std::regex("://[^/@\\s]*:[^@\\s]*@"), "://***@");
  text = std::regex_replace(text, std::regex("password\\s*=\\s*('[^']*'|[^\\s&]+)", std::regex::icase), "password=***");
  return on_one_line(std::move(text));
}

}  // namespace opal::postgis_store
