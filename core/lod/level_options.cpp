#include "core/lod/level_options.h"

#include "core/base/number_text.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace ramure {
namespace {

/// \param numbers of each level but the first; none: the usual ones
Expected<void> checkSwitches(const std::vector<double>& numbers, std::int64_t count, bool areShares)
{
    if (numbers.empty())
        return {};
    if (static_cast<std::int64_t>(numbers.size()) != count - 1)
        return fail(
            ErrorCode::Invalid,
            RAMURE_NOOP("%1 levels of detail change %2 times: as many distances or shares expected, not %3"),
            {std::to_string(count), std::to_string(count - 1), std::to_string(numbers.size())});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::string level = std::to_string(i + 1);
        if (!std::isfinite(numbers[i]) || numbers[i] <= 0.0)
            return fail(ErrorCode::Invalid,
                        areShares ? RAMURE_NOOP("level %1: its share of the picture's height must be over 0")
                                  : RAMURE_NOOP("level %1: its distance must be over 0"),
                        {level});
        if (areShares && numbers[i] > mostShare)
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("level %1: %2 % of the picture's height is more than the most, %3 %"),
                        {level, numberText(100.0 * numbers[i]), numberText(100.0 * mostShare)});
        if (i == 0 || (areShares ? numbers[i] < numbers[i - 1] : numbers[i] > numbers[i - 1]))
            continue;
        if (areShares)
            return fail(
                ErrorCode::Invalid,
                RAMURE_NOOP("level %1: shares of the picture must fall, and %2 % is not less than %3 %"),
                {level, numberText(100.0 * numbers[i]), numberText(100.0 * numbers[i - 1])});
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("level %1: distances must rise, and %2 m is not farther than %3 m"),
                    {level, numberText(numbers[i]), numberText(numbers[i - 1])});
    }
    return {};
}

constexpr std::string_view blanks = " \t\u00a0\u202f"; ///< languages put narrow ones before a unit

std::string_view trimmed(std::string_view text)
{
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos ? std::string_view()
                                          : text.substr(from, text.find_last_not_of(blanks) + 1 - from);
}

struct Switch
{
    double number = 0.0;
    bool isShare = false;
};

std::optional<Switch> switchIn(std::string_view text)
{
    Switch out;
    text = trimmed(text);
    out.isShare = text.ends_with('%');
    if (out.isShare || text.ends_with('m'))
        text = trimmed(text.substr(0, text.size() - 1));
    std::string plain(text);
    for (char& letter : plain)
        letter = letter == ',' ? '.' : letter;
    const char* end = plain.data() + plain.size();
    const auto read = std::from_chars(plain.data(), end, out.number);
    if (read.ec != std::errc() || read.ptr != end)
        return std::nullopt;
    out.number *= out.isShare ? 0.01 : 1.0;
    return out;
}

} // namespace

LevelOptions gameLevels()
{
    return {.count = 4, .budgets = {80'000, 20'000, 5'000, 1'250}, .cards = true, .billboard = true};
}

Expected<void> checkLevels(const LevelOptions& options)
{
    if (options.count < 1 || options.count > mostLevels)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("%1 levels of detail: 1 to %2 are possible"),
                    {std::to_string(options.count), std::to_string(mostLevels)});
    const std::vector<std::int64_t>& budgets = options.budgets;
    if (!budgets.empty() && static_cast<std::int64_t>(budgets.size()) != options.count)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("%1 levels of detail need as many budgets, not %2"),
                    {std::to_string(options.count), std::to_string(budgets.size())});
    for (std::size_t i = 0; i < budgets.size(); ++i) {
        if (budgets[i] < leastBudget)
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("level %1: a budget of %2 triangles is less than the least, %3"),
                        {std::to_string(i), std::to_string(budgets[i]), std::to_string(leastBudget)});
        if (budgets[i] > mostBudget)
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("level %1: a budget of %2 triangles is more than the most, %3"),
                        {std::to_string(i), std::to_string(budgets[i]), std::to_string(mostBudget)});
        if (i > 0 && budgets[i] >= budgets[i - 1])
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("level %1: budgets must fall, and %2 triangles are not fewer than %3"),
                        {std::to_string(i), std::to_string(budgets[i]), std::to_string(budgets[i - 1])});
    }
    if (!options.distances.empty() && !options.shares.empty())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("levels change at distances or at shares of the picture, not at both"));
    if (auto fine = checkSwitches(options.distances, options.total(), false); !fine)
        return fine;
    return checkSwitches(options.shares, options.total(), true);
}

Expected<void> readSwitches(std::string_view text, LevelOptions& options)
{
    std::vector<double> distances, shares;
    const char comma = text.find(';') == std::string_view::npos ? ',' : ';';
    for (std::string_view rest = text; !trimmed(rest).empty();) {
        const std::size_t end = std::min(rest.find(comma), rest.size());
        const std::string_view part = rest.substr(0, end);
        const auto read = switchIn(part);
        if (!read)
            return fail(
                ErrorCode::Invalid,
                RAMURE_NOOP("\"%1\": a distance in metres, or a share of the picture such as 30 %, expected"),
                {std::string(trimmed(part))});
        (read->isShare ? shares : distances).push_back(read->number);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!distances.empty() && !shares.empty())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("levels change at distances or at shares of the picture, not at both"));
    options.distances = std::move(distances);
    options.shares = std::move(shares);
    return {};
}

std::string switchesText(const LevelOptions& options)
{
    std::string text;
    for (const double distance : options.distances)
        text.append(text.empty() ? "" : "; ").append(numberText(distance));
    for (const double share : options.shares) // a hundredth of a percent: 0.3 is 30 %, not 30.000000000000004
        text.append(text.empty() ? "" : "; ")
            .append(numberText(std::round(1e4 * share) / 100.0))
            .append(" %");
    return text;
}

} // namespace ramure
