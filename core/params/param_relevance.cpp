#include "core/params/param_relevance.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ramure {
namespace {

constexpr std::array round{"cylinder", "sphere", "cone", "frameCross"};
constexpr std::array tall{"cylinder", "cone", "frameCross"};
constexpr std::array angular{"box", "plane"};
constexpr std::array standing{"cylinder", "sphere", "box", "cone", "plane"};
constexpr std::array robust{"robust"};
constexpr std::array transpose{"transpose"};

constexpr std::array relevances{
    Relevance{"primitive.radius", "primitive.shape", round},
    Relevance{"primitive.height", "primitive.shape", tall},
    Relevance{"primitive.size", "primitive.shape", angular},
    Relevance{"primitive.sides", "primitive.shape", round},
    Relevance{"primitive.axis", "primitive.shape", standing},
    Relevance{"physics.substeps", "physics.mode", robust},
    Relevance{"physics.settled", "physics.mode", robust},
    Relevance{"ik.gain", "ik.solver", transpose},
};

} // namespace

const Relevance* relevanceOf(const ParamDef& def)
{
    const auto* found = std::ranges::find_if(
        relevances, [&](const Relevance& each) { return std::string_view(each.key) == def.key; });
    return found == relevances.end() ? nullptr : found;
}

bool isRelevant(const NodeParams& params, const ParamDef& def)
{
    const Relevance* relevance = relevanceOf(def);
    if (!relevance)
        return true;
    const ParamValue chosen = findParam(relevance->chooser)->get(params);
    const auto* item = std::get_if<EnumValue>(&chosen);
    return !item ||
           std::ranges::any_of(relevance->items, [&](const char* name) { return item->name == name; });
}

} // namespace ramure
