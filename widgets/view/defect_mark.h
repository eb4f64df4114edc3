/// \file
/// A defect of a mesh as the viewport shows it: drawn through everything, with its name beside it, and
/// without leaves and apples in the way.
#pragma once

#include "core/skeleton/simplify.h"
#include "widgets/base/defect_place.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <QString>

class QPainter;

namespace ramure {

class DefectMark
{
public:
    void show(const DefectPlace& place);
    /// \return false where none was shown
    bool clear();
    [[nodiscard]] bool isShown() const { return m_lines != nullptr; }
    /// Another one after every change.
    [[nodiscard]] quint64 revision() const { return m_revision; }
    /// Adds what marks it, and lets leaves and apples fade: they are not picked any more and throw no shadow.
    void addTo(RenderScene& scene) const;
    /// Its name, a little away from it. \param view of logical pixels.
    void paintLabel(QPainter& painter, const PickView& view) const;

private:
    std::shared_ptr<const LineSet> m_lines;
    std::shared_ptr<const PointSet> m_points;
    glm::dvec3 m_middle{0.0};
    QString m_label;
    quint64 m_revision = 0;
};

/// How far around a defect one should see, m: some lengths of the branch that it lies on, at least the defect
/// and at most the whole node. \param tree of the node, or null. \param world of the node. \param node its
/// box, world.
double defectReach(const DefectPlace& place, const SimplifiedSkeleton* tree, const glm::dmat4& world,
                   const Box& node);

/// A camera that looks at the defect from as far as \p reach asks for, as nearly from where \p from looks as
/// a free line of sight allows: what is opaque in \p scene stands before as few of the defect's parts as
/// possible. From above the ground, where the ground is shown and the defect stands above it.
Camera defectView(const RenderScene& scene, const DefectPlace& place, double reach, const Camera& from,
                  double aspect, bool ground);

} // namespace ramure
