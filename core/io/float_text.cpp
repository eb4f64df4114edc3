#include "core/io/float_text.h"
#include <algorithm>

namespace ramure {

bool isTooSmall(std::string_view number)
{
    const std::string_view digits = number.substr(0, number.find_first_of("eE"));
    double exponent = 0.0; // so that no exponent is too long
    if (digits.size() < number.size()) {
        const char* const end = number.data() + number.size();
        std::from_chars(behindPlus(number.data() + digits.size() + 1, end), end, exponent);
    }
    const auto first = static_cast<double>(digits.find_first_of("123456789"));
    const auto point = static_cast<double>(std::min(digits.find('.'), digits.size()));
    return exponent + point < first;
}

} // namespace ramure
