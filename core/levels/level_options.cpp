#include "core/levels/level_options.h"

#include <string>

namespace ramure {

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
    return {};
}

} // namespace ramure
