/// \file
/// The longest life that a growing tree has had so far. Whoever makes it older goes on from there: the years
/// before are not grown again.
#pragma once

#include "core/generators/sources.h"
#include "core/generators/tree_life.h"
#include <optional>

namespace ramure {

/// Of one tree: another one takes its place.
class LongestLife
{
public:
    /// At least the years that \p params ask for. Errors: those of growSymbols(); the years that were grown
    /// before it was cancelled are kept. \param life StageHashes::life()
    Expected<GrownSymbols> grow(std::uint64_t life, const NodeParams& params, const Progress& progress)
    {
        const double years = historyYears(params);
        if (!m_run || m_life != life) {
            *this = {};
            auto begun = beginLife(params, progress);
            RAMURE_TRY(begun);
            m_run.emplace(std::move(*begun));
            m_life = life;
        }
        if (m_history && double(m_history->grownYears()) >= years)
            return GrownSymbols{{}, {}, m_history};
        if (auto grown = m_run->growTo(years, progress); !grown) {
            if (grown.error().code != ErrorCode::Cancelled)
                *this = {}; // it is too large already
            return fail(std::move(grown.error()));
        }
        m_history = std::make_shared<const GrowthHistory>(m_run->history());
        return GrownSymbols{{}, {}, m_history};
    }

private:
    std::uint64_t m_life = 0;
    std::optional<GrowthRun> m_run;
    std::shared_ptr<const GrowthHistory> m_history; ///< of the run when it had grown last
};

} // namespace ramure
