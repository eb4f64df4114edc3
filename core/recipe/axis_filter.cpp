#include "core/recipe/axis_filter.h"

#include "core/skeleton/axes.h"
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <numbers>
#include <unordered_map>

namespace ramure {
namespace {

constexpr const char* path = "step.where";

/// The operators that words stand for, as long as the words, so that columns stay.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> words{
    {{"and", "&& "}, {"or", "||"}, {"not", "!  "}}};

bool isPartOfName(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string withOperators(std::string_view text)
{
    std::string out(text);
    for (std::size_t at = 0; at < out.size();) {
        std::size_t end = at;
        while (end < out.size() && isPartOfName(out[end]))
            ++end;
        for (const auto& [word, sign] : words)
            if (std::string_view(out).substr(at, end - at) == word)
                out.replace(at, word.size(), sign);
        at = std::max(end, at + 1);
    }
    return out;
}

const std::vector<std::string>& factNames()
{
    static const std::vector<std::string> names{"share",   "s",     "length", "radius",
                                                "azimuth", "angle", "height", "forks"};
    return names;
}

constexpr std::string_view listWord = "axes", separators = " ,\t\n";

/// Of a list: what stands behind its word.
Expected<std::vector<std::uint64_t>> readAddresses(std::string_view text, std::size_t at)
{
    std::vector<std::uint64_t> addresses;
    for (;;) {
        at = std::min(text.find_first_not_of(separators, at), text.size());
        const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
        std::uint64_t address = 0;
        const char* const last = text.data() + end;
        const auto [stop, problem] = std::from_chars(text.data() + at, last, address, 16);
        if (at == text.size() && !addresses.empty())
            break;
        if (at == text.size() || problem != std::errc() || stop != last) {
            auto error = fail(ErrorCode::Invalid,
                              RAMURE_NOOP("the address of an axis is expected here: digits 0-9, a-f"));
            error.value().path = path;
            error.value().column = static_cast<int>(at) + 1;
            return error;
        }
        addresses.push_back(address);
        at = end;
    }
    std::ranges::sort(addresses);
    return addresses;
}

} // namespace

std::string AxisFilter::ofAxes(std::span<const std::uint64_t> addresses)
{
    std::string text(listWord);
    for (const std::uint64_t address : addresses) {
        char digits[16];
        const auto end = std::to_chars(std::begin(digits), std::end(digits), address, 16).ptr;
        text += (text.size() == listWord.size() ? " " : ", ") + std::string(digits, end);
    }
    return text;
}

Expected<AxisFilter> AxisFilter::parse(std::string_view text)
{
    AxisFilter filter;
    const std::size_t first = text.find_first_not_of(" \t\n");
    if (first == std::string_view::npos)
        return filter;
    const std::size_t behind = first + listWord.size();
    if (text.substr(first).starts_with(listWord) &&
        (text.size() == behind || separators.find(text[behind]) != std::string_view::npos)) {
        auto addresses = readAddresses(text, behind);
        RAMURE_TRY(addresses);
        filter.m_addresses = std::move(*addresses);
        return filter;
    }
    const std::string signs = withOperators(text);
    TextScanner scanner(signs, path, 1, true);
    ExpressionNames names;
    names.parameters = factNames();
    auto condition = parseExpression(scanner, names);
    RAMURE_TRY(condition);
    if (!scanner.atEnd())
        return failAt(scanner.place(), ErrorCode::Syntax, RAMURE_NOOP("the condition should end here"));
    filter.m_condition = std::move(*condition);
    return filter;
}

std::vector<bool> AxisFilter::axesOf(const EditTree& tree) const
{
    std::vector<bool> marks(tree.axisCount(), false);
    if (m_condition.empty()) {
        for (Index a = 0; a < tree.axisCount(); ++a)
            marks[a] = !tree.isGone(a) &&
                       (m_addresses.empty() || std::ranges::binary_search(m_addresses, tree.axis(a).address));
        return marks;
    }
    constexpr double degree = 180.0 / std::numbers::pi;
    const Skeleton skeleton = tree.skeleton();
    const TreeAxes axes = ramure::axesOf(skeleton);
    std::unordered_map<std::uint64_t, const Axis*> byAddress;
    for (const Axis& axis : axes.axes)
        byAddress.emplace(axis.address, &axis);
    for (Index a = 0; a < tree.axisCount(); ++a) {
        const auto found = byAddress.find(tree.axis(a).address);
        if (tree.isGone(a) || found == byAddress.end())
            continue;
        const Axis& axis = *found->second;
        const std::array facts{axis.share,
                               axis.s,
                               axis.length,
                               axis.radius,
                               axis.azimuth * degree,
                               axis.downAngle * degree,
                               tree.piece(tree.axis(a).first).p0.y,
                               static_cast<double>(axis.forks)};
        ExpressionInputs inputs;
        inputs.parameters = facts.data();
        inputs.order = axis.order;
        const double value = m_condition.value(inputs);
        marks[a] = value == value && value != 0.0;
    }
    return marks;
}

} // namespace ramure
