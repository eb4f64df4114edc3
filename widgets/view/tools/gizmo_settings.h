/// \file
/// How nodes are moved by hand in the view, and what of their motion is drawn: which tool, in which axes,
/// what values snap to, the path and the ghosts. Exists also where OpenGL does not.
#pragma once

#include "core/scene/node_transform.h"
#include "widgets/base/option.h"
#include <QObject>
#include <QVariantMap>

namespace ramure {

/// The tools of the view that shape no tree. Measure is the tape measure.
enum class TransformTool : quint8 { Select, Move, Rotate, Scale, Measure };

/// It has handles.
constexpr bool transforms(TransformTool tool)
{
    return tool != TransformTool::Select && tool != TransformTool::Measure;
}

/// The steps that dragged values snap to.
struct SnapSteps
{
    double move = 0.1;    ///< m
    double turnDeg = 5.0; ///< degrees
    double scale = 0.1;   ///< step of a factor
    bool operator==(const SnapSteps&) const = default;
};

/// Copies of moving nodes at frames around the playhead.
struct GhostFrames
{
    int before = 3, after = 3; ///< how many
    int step = 5;              ///< frames from one to the next
    bool operator==(const GhostFrames&) const = default;
};

class GizmoSettings : public QObject
{
    Q_OBJECT
public:
    static constexpr int mostGhosts = 20, mostGhostStep = 1000;

    explicit GizmoSettings(QObject* parent = nullptr);

    template <class T> using Option = ramure::Option<GizmoSettings, T>;
    Option<TransformTool> tool{this, TransformTool::Select};
    Option<TransformSpace> space{this, TransformSpace::World};
    Option<bool> snaps{this, false}; ///< always; Ctrl turns it round while dragging
    Option<bool> showsPath{this, false};
    Option<bool> showsGhosts{this, false};
    Option<bool> radians{this, false}; ///< angles are typed and shown in radians
    [[nodiscard]] SnapSteps steps() const { return m_steps(); }
    [[nodiscard]] GhostFrames ghostFrames() const { return m_ghostFrames(); }

    /// The settings that are remembered between sessions: the steps, and the frames that ghosts show.
    [[nodiscard]] QVariantMap saved() const;
    void restore(const QVariantMap& saved); ///< a value that is missing or out of range is not changed

    /// Gives tool, axes, snapping, path and ghosts their defaults. Remembered settings stay.
    void beginDocument();
    void setSteps(const ramure::SnapSteps& steps);          ///< steps of 0 and less are ignored
    void setGhostFrames(const ramure::GhostFrames& frames); ///< clamped

signals:
    void changed();

private:
    Option<SnapSteps> m_steps{this, {}};
    Option<GhostFrames> m_ghostFrames{this, {}};
};

} // namespace ramure
