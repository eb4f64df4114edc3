/// \file
/// The boundary of a fork's cell in the unrolled plane of its child's tube.
#pragma once

#include "core/surface/mesher/fork_walls.h"
#include "core/surface/mesher/strip_patch.h"

namespace ramure {

/// \param boundary of the child's cell. Azimuths of \p out are in the child's own (rolled) frames and
/// strictly increasing over one turn; those on the ring are exact, those of walls follow the projection on
/// the child's axis as far as it is increasing.
class CellUnroller
{
public:
    void unroll(const std::vector<CellVertex>& boundary, const ForkChild& child, Index self, double rollRad,
                std::vector<UnrolledVertex>& out);

private:
    void smoothRun(const std::vector<CellVertex>& boundary, std::size_t from, std::size_t steps, double total,
                   std::vector<UnrolledVertex>& out);
    std::vector<double> m_increments;
};

/// Height of a row over an azimuth, linear between its vertices.
double alongAt(const std::vector<UnrolledVertex>& row, double azimuth);

} // namespace ramure
