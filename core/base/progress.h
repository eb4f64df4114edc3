/// \file
/// A long function gets a Progress to report how far it is and to learn that it should stop.
#pragma once

#include <functional>
#include <stop_token>

namespace ramure {

/// Copyable. A default-made one reports nowhere and never stops.
struct Progress
{
    std::stop_token stop;
    std::function<void(double)> onFraction; ///< 0..1, called on the working thread, rarely (not per element)

    [[nodiscard]] bool cancelled() const { return stop.stop_requested(); }
    void report(double fraction) const
    {
        if (onFraction)
            onFraction(fraction);
    }
    /// The same stop token; fractions 0..1 of the part are mapped to [from, to] of the whole.
    [[nodiscard]] Progress part(double from, double to) const
    {
        if (!onFraction)
            return {stop, {}};
        return {stop, [whole = onFraction, from, to](double f) { whole(from + f * (to - from)); }};
    }
};

} // namespace ramure
