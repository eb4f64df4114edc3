// Checking, clamping and the text form of parameter values: everything that works from a row alone.
#include "core/base/number_text.h"
#include "core/math/finite.h"
#include "core/params/param_def.h"

#include "core/params/arm_params.h"
#include "core/params/tree_edit_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ramure {
namespace {

constexpr std::size_t maxTextBytes = std::size_t(1) << 20;

tl::unexpected<Error> refuse(const ParamDef& def, ErrorCode code, const char* text,
                             std::vector<std::string> args = {})
{
    auto error = fail(code, text, std::move(args));
    error.value().path = def.key;
    return error;
}

/// Whole numbers with all their digits: 20000000, not 2e+07.
std::string boundText(const ParamDef& def, double bound)
{
    return def.type == ParamType::Int ? numberText(static_cast<std::int64_t>(bound)) : numberText(bound);
}

tl::unexpected<Error> outOfRange(const ParamDef& def, std::string given)
{
    return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("must be between %1 and %2, not %3"),
                  {boundText(def, def.hardMin), boundText(def, def.hardMax), std::move(given)});
}

Expected<void> checkNumber(const ParamDef& def, double number)
{
    if (!std::isfinite(number))
        return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("must be a finite number"));
    if (number < def.hardMin || number > def.hardMax)
        return outOfRange(def, numberText(number));
    return {};
}

Expected<void> checkText(const ParamDef& def, const std::string& text)
{
    if (text.size() > maxTextBytes)
        return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("the text is longer than %1 bytes"),
                      {numberText(maxTextBytes)});
    if (text.find('\0') != std::string::npos)
        return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("the text holds a zero byte"));
    return {};
}

const EnumItem* findItem(const ParamDef& def, const EnumValue& value)
{
    const auto found = std::ranges::find(def.items, value.name, &EnumItem::name);
    return found == def.items.end() ? nullptr : &*found;
}

Expected<void> checkItem(const ParamDef& def, const EnumValue& value)
{
    if (findItem(def, value))
        return {};
    std::string names;
    for (const EnumItem& item : def.items)
        names.append(names.empty() ? "" : ", ").append(item.name);
    return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("must be one of %1, not \"%2\""), {names, value.name});
}

double clampNumber(const ParamDef& def, double number, double fallback)
{
    return std::isfinite(number) ? std::clamp(number, def.hardMin, def.hardMax) : fallback;
}

std::string_view trimmed(std::string_view text)
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

template <class T> Expected<T> parseNumber(const ParamDef& def, std::string_view text)
{
    std::string_view digits = trimmed(text);
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
        digits.remove_prefix(1);
    T number{};
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (status == std::errc::result_out_of_range)
        return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("the number %1 is out of all range"),
                      {std::string(digits)});
    if (status != std::errc() || end != digits.data() + digits.size()) {
        constexpr const char* whole = RAMURE_NOOP("\"%1\" is not a whole number");
        constexpr const char* real = RAMURE_NOOP("\"%1\" is not a number");
        return refuse(def, ErrorCode::Syntax, std::is_integral_v<T> ? whole : real,
                      {std::string(trimmed(text))});
    }
    return number;
}

/// Also "3.0", as pandas writes whole numbers of a column with gaps; "10.000" may be ten thousand.
Expected<std::int64_t> parseWhole(const ParamDef& def, std::string_view text)
{
    std::string_view digits = trimmed(text);
    for (const std::string_view fraction : {".0", ".00"})
        if (digits.ends_with(fraction)) {
            digits.remove_suffix(fraction.size());
            break;
        }
    auto number = parseNumber<std::int64_t>(def, digits);
    return number ? number : parseNumber<std::int64_t>(def, text); // the error names what was given
}

Expected<ParamValue> parseBool(const ParamDef& def, std::string_view text)
{
    std::string word(text); // spreadsheets write TRUE, pandas True, or 1.0 in a column with gaps
    for (char& letter : word)
        letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 'a' - 'A') : letter;
    for (const std::string_view yes : {"true", "1", "1.0", "yes", "on"})
        if (word == yes)
            return ParamValue(true);
    for (const std::string_view no : {"false", "0", "0.0", "no", "off"})
        if (word == no)
            return ParamValue(false);
    return refuse(def, ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is neither true nor false"),
                  {std::string(text)});
}

Expected<ParamValue> parseVec3(const ParamDef& def, std::string_view text)
{
    glm::dvec3 vector(0.0);
    std::size_t from = 0;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = text.find(',', from);
        if ((comma == std::string_view::npos) != (i == 2))
            return refuse(def, ErrorCode::Syntax,
                          RAMURE_NOOP("\"%1\" is not three numbers with commas between"),
                          {std::string(text)});
        const auto part = parseNumber<double>(def, text.substr(from, comma - from));
        RAMURE_TRY(part);
        vector[i] = *part;
        from = comma + 1;
    }
    return ParamValue(vector);
}

std::string unescaped(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char next = text[i] == '\\' && i + 1 < text.size() ? text[i + 1] : '\0';
        if (next == 'n' || next == '\\') {
            out += next == 'n' ? '\n' : '\\';
            ++i;
        } else {
            out += text[i];
        }
    }
    return out;
}

} // namespace

ParamValue defaultValue(const ParamDef& def)
{
    return def.get(NodeParams());
}

Expected<void> checkValue(const ParamDef& def, const ParamValue& value)
{
    if (value.index() != static_cast<std::size_t>(def.type))
        return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("has a value of another type"));
    switch (def.type) {
    case ParamType::Bool:
        return {};
    case ParamType::Int: {
        const std::int64_t number = std::get<std::int64_t>(value);
        if (number < static_cast<std::int64_t>(def.hardMin) ||
            number > static_cast<std::int64_t>(def.hardMax))
            return outOfRange(def, numberText(number));
        return {};
    }
    case ParamType::Real:
        return checkNumber(def, std::get<double>(value));
    case ParamType::Text:
        return checkText(def, std::get<std::string>(value));
    case ParamType::Vec3:
        for (int i = 0; i < 3; ++i)
            if (auto ok = checkNumber(def, std::get<glm::dvec3>(value)[i]); !ok)
                return ok;
        return {};
    case ParamType::Enum:
        return checkItem(def, std::get<EnumValue>(value));
    }
    return {};
}

Expected<void> setParam(NodeParams& params, const ParamDef& def, const ParamValue& value)
{
    if (auto ok = checkValue(def, value); !ok)
        return ok;
    def.assign(params, value);
    return {};
}

ParamValue clampValue(const ParamDef& def, const ParamValue& value)
{
    const ParamValue fallback = defaultValue(def);
    if (value.index() != fallback.index())
        return fallback;
    switch (def.type) {
    case ParamType::Bool:
        return value;
    case ParamType::Int:
        return std::clamp(std::get<std::int64_t>(value), static_cast<std::int64_t>(def.hardMin),
                          static_cast<std::int64_t>(def.hardMax));
    case ParamType::Real:
        return clampNumber(def, std::get<double>(value), std::get<double>(fallback));
    case ParamType::Text:
    case ParamType::Enum:
        return checkValue(def, value) ? value : fallback;
    case ParamType::Vec3: {
        glm::dvec3 vector = std::get<glm::dvec3>(value);
        for (int i = 0; i < 3; ++i)
            vector[i] = clampNumber(def, vector[i], std::get<glm::dvec3>(fallback)[i]);
        return vector;
    }
    }
    return fallback;
}

std::string formatValue(const ParamValue& value)
{
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return numberText(*whole);
    if (const auto* real = std::get_if<double>(&value))
        return numberText(*real);
    if (const auto* text = std::get_if<std::string>(&value))
        return *text;
    if (const auto* choice = std::get_if<EnumValue>(&value))
        return choice->name;
    const auto& vector = std::get<glm::dvec3>(value);
    return numberText(vector.x) + "," + numberText(vector.y) + "," + numberText(vector.z);
}

Expected<ParamValue> parseValue(const ParamDef& def, std::string_view text, bool unescape)
{
    switch (def.type) {
    case ParamType::Bool:
        return parseBool(def, trimmed(text));
    case ParamType::Int:
        return parseWhole(def, text).map([](std::int64_t number) { return ParamValue(number); });
    case ParamType::Real:
        return parseNumber<double>(def, text).map([](double number) { return ParamValue(number); });
    case ParamType::Text:
        return ParamValue(unescape ? unescaped(text) : std::string(text));
    case ParamType::Vec3:
        return parseVec3(def, text);
    case ParamType::Enum: {
        const std::string_view name = trimmed(text);
        if (def.flags & paramNumbered)
            if (const auto at = parseWhole(def, name); at && *at >= 0 && *at < std::ssize(def.items))
                return ParamValue(EnumValue{def.items[static_cast<std::size_t>(*at)].name});
        return ParamValue(EnumValue{std::string(name)});
    }
    }
    return refuse(def, ErrorCode::Invalid, RAMURE_NOOP("has a value of another type"));
}

Expected<void> checkParams(const NodeParams& params)
{
    for (const ParamDef& def : paramTable())
        if (auto ok = checkValue(def, def.get(params)); !ok)
            return ok;
    if (auto ok = checkArm(params.joints); !ok)
        return ok;
    return checkTreeEdits(params.edits);
}

} // namespace ramure
