#include "core/generators/growth/grown_skeleton.h"

#include "core/generators/growth/age_cutter.h"
#include "core/generators/growth/bark_marks.h"
#include "core/generators/growth/palm.h"
#include <algorithm>

namespace ramure {
namespace {

Skeleton marked(const GrowthHistory& history, double age)
{
    std::vector<Index> ends;
    Skeleton tree = growth::AgeCutter(history, age).draw(&ends);
    growth::markBark(history, int(age), ends, tree);
    return tree;
}

} // namespace

Skeleton skeletonAtAge(const GrowthHistory& history, double age)
{
    age = std::clamp(age, 0.0, double(history.grownYears()));
    Skeleton tree;
    if (history.params.habit == GrowthHabit::Branching)
        tree = marked(history, age);
    else if (history.diedAt == 0 || age < history.diedAt)
        tree = palmAtAge(history.params, history.seed, age, history.cuts);
    using enum LivedEdit::State;
    for (std::size_t c = 0; c < history.cuts.size(); ++c)
        if (const GrowthCut& cut = history.cuts[c]; cut.edit != 0)
            tree.lived.push_back({cut.edit, double(cut.age) > age ? Waits
                                            : history.isMade[c]   ? Made
                                                                  : Missed});
    return tree;
}

} // namespace ramure
