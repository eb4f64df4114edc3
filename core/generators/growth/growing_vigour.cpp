// Vigour: how much each bud may grow.
#include "core/generators/growth/growing_tree.h"

#include <algorithm>

namespace ramure::growth {

/// Branches live on what their own leaves make (Sprugel, Hinckley, Schaap: "The theory and practice of branch
/// autonomy", 1991), and a leader takes what it needs. What all claim is no more than the roots pay for.
double GrowingTree::claim(const YearFactors& factors)
{
    double all = 0.0;
    for (const Index i : m_active) {
        Flow& flow = m_flow[i];
        const unsigned order = m_nodes[i].order;
        const double side = m_params.autonomy * factors.sideLongest[order + 1];
        if (flow.ownSide > 0.0 && order + 1 < unsigned(m_params.orders))
            all += flow.sideVigour = flow.ownSide * side;
        if (flow.active == 0 || !m_nodes[i].tip)
            continue;
        const double own = double(m_nodes[i].light);
        if (order == 0)
            flow.tipVigour = factors.claim * std::min(1.0, 2.0 * own);
        else
            all += flow.tipVigour = own * m_params.autonomy * factors.sideLongest[order];
    }
    const double share = all > 0.0 ? std::min(1.0, 0.7 * factors.vigourCap / all) : 0.0;
    double given = 0.0;
    for (const Index i : m_active) {
        Flow& flow = m_flow[i];
        flow.sideVigour *= share;
        if (m_nodes[i].order != 0)
            flow.tipVigour *= share;
        given += flow.sideVigour + flow.tipVigour;
    }
    return given;
}

double GrowingTree::lambdaOf(Index axis, const YearFactors& factors) const
{
    const bool trunk = m_history.axisOrder[axis] == 0 || m_axes[axis].upright;
    return trunk ? factors.trunkLambda : factors.limbLambda;
}

void GrowingTree::shareVigour(const YearFactors& factors)
{
    double all = 0.0;
    for (Index i = 0; i < living(); ++i)
        if (m_nodes[i].parent == noIndex)
            all += m_flow[i].main + m_flow[i].side;
    constexpr double alpha = 2.0;
    const double seedling = std::min({double(factors.year + 1), factors.longest, 4.0 * all});
    const double whole = std::min(std::max(alpha * all, seedling), factors.vigourCap);
    m_year.vigour = (all > 0.0 ? whole : 0.0) + claim(factors);
    m_year.vigourSpent = 0.0;
    for (Index i = 0; i < living(); ++i)
        if (m_nodes[i].parent == noIndex)
            m_flow[i].vigour = all > 0.0 ? whole * (m_flow[i].main + m_flow[i].side) / all : 0.0;
    if (m_params.vigour == VigourModel::Priority)
        shareByRank();
    else
        shareAtForks(factors);
}

/// Borchert and Honda, "Control of development in the bifurcating branch system of Tabebuia rosea" (1984), as
/// in section 4.2 of Palubicki et al.
void GrowingTree::shareAtForks(const YearFactors& factors)
{
    for (Index i = 0; i < living(); ++i) {
        Flow& flow = m_flow[i];
        const Index parent = m_nodes[i].parent;
        const double light = flow.main + flow.side;
        if (parent != noIndex) {
            const Index axis = m_nodes[parent].axis;
            const double lambda = lambdaOf(axis, factors);
            const double share = m_nodes[i].axis == axis ? lambda : 1.0 - lambda;
            flow.vigour = m_flow[parent].vigour * share * light;
        }
        const double lambda = lambdaOf(m_nodes[i].axis, factors);
        const double sum = lambda * flow.main + (1.0 - lambda) * flow.side;
        if (m_nodes[i].tip && sum > 0.0)
            flow.tipVigour += flow.vigour * lambda * flow.main / sum;
        if (sum > 0.0)
            flow.sideVigour += flow.vigour * (1.0 - lambda) * flow.ownSide / sum;
        flow.vigour = sum > 0.0 ? flow.vigour / sum : 0.0; // of each unit of weighted light
    }
}

/// The priority model, section 4.2 of Palubicki et al.: along an axis, what has more light comes first, and
/// weights fall with the rank.
void GrowingTree::shareByRank()
{
    std::vector<std::vector<Index>> axes(m_axes.size());
    std::vector<std::vector<Index>> sides(m_axes.size()); // bases of the axes on each
    for (Index i = 0; i < living(); ++i) {
        const Index axis = m_nodes[i].axis, parent = m_nodes[i].parent;
        axes[axis].push_back(i);
        if (parent != noIndex && m_nodes[parent].axis != axis)
            sides[m_nodes[parent].axis].push_back(i);
    }
    std::vector<RankedLight> ranked;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) { // parents come before children
        if (axes[axis].empty())
            continue;
        const double vigour = m_flow[axes[axis].front()].vigour;
        ranked.clear();
        for (const Index i : axes[axis]) {
            Flow& flow = m_flow[i];
            if (m_nodes[i].tip && flow.active > 0)
                ranked.push_back({double(m_nodes[i].light), i, &flow.tipVigour});
            if (flow.ownSide > 0.0)
                ranked.push_back({flow.ownSide, i, &flow.sideVigour});
        }
        for (const Index i : sides[axis])
            if (Flow& flow = m_flow[i]; flow.active > 0)
                ranked.push_back({double(flow.light) / double(flow.active), i, &flow.vigour});
        rank(ranked, vigour);
    }
}

void GrowingTree::rank(std::vector<RankedLight>& ranked, double vigour) const
{
    constexpr double least = 0.006; // weight of the last, of that of the first
    std::ranges::stable_sort(ranked, [](const RankedLight& a, const RankedLight& b) {
        return a.light > b.light || (a.light == b.light && a.node < b.node);
    });
    const double falls = std::max(1.0, (1.0 - 0.8 * m_params.apicalControl) * double(ranked.size()));
    double sum = 0.0;
    for (std::size_t k = 0; k < ranked.size(); ++k) {
        ranked[k].light *= std::max(least, 1.0 - double(k) / falls);
        sum += ranked[k].light;
    }
    for (const RankedLight& item : ranked)
        *item.vigour += sum > 0.0 ? vigour * item.light / sum : 0.0;
}

} // namespace ramure::growth
