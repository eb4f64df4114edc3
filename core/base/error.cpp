#include "core/base/error.h"

namespace ramure {

std::string Error::plain() const
{
    std::string out;
    for (const char* c = text; *c != '\0'; ++c) {
        const bool isPlace = *c == '%' && c[1] >= '1' && c[1] <= '9';
        if (!isPlace) {
            out += *c;
            continue;
        }
        const auto index = static_cast<std::size_t>(*++c - '1');
        out += index < args.size() ? args[index] : std::string();
    }
    return out;
}

std::string Error::message() const
{
    std::string out;
    if (!file.empty())
        out += file + ":";
    if (line > 0)
        out += std::to_string(line) + ":";
    if (column > 0)
        out += std::to_string(column) + ":";
    if (!out.empty())
        out += ' ';
    if (!path.empty())
        out += path + ": ";
    return out + plain();
}

} // namespace ramure
