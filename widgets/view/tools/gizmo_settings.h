/// \file
/// How nodes are moved by hand in the view, and what of their motion is drawn: which tool, in which axes,
/// what values snap to, the path and the ghosts. Exists also where OpenGL does not.
#pragma once

#include "core/scene/node_transform.h"
#include <QObject>
#include <QVariantMap>

namespace ramure {

enum class TransformTool : quint8 { Select, Move, Rotate, Scale };

/// What dragged values snap to.
struct SnapSteps
{
    double move = 0.1;    ///< m
    double turnDeg = 5.0; ///< degrees
    double scale = 0.1;   ///< of a factor
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

    [[nodiscard]] TransformTool tool() const { return m_tool; }
    [[nodiscard]] TransformSpace space() const { return m_space; }
    [[nodiscard]] bool snaps() const { return m_snaps; } ///< always; Ctrl turns it round while dragging
    [[nodiscard]] SnapSteps steps() const { return m_steps; }
    [[nodiscard]] bool showsPath() const { return m_path; }
    [[nodiscard]] bool showsGhosts() const { return m_ghosts; }
    [[nodiscard]] GhostFrames ghostFrames() const { return m_ghostFrames; }
    [[nodiscard]] bool radians() const { return m_radians; } ///< angles are typed and shown in radians

    /// What is remembered between sessions: the steps, and which frames ghosts show.
    [[nodiscard]] QVariantMap saved() const;
    void restore(const QVariantMap& saved); ///< what is missing or out of range stays as it is

public slots:
    /// Gives tool, axes, snapping, path and ghosts their defaults. What is remembered stays.
    void beginDocument();
    void setTool(ramure::TransformTool tool);
    void setSpace(ramure::TransformSpace space);
    void setSnaps(bool on);
    void setSteps(const ramure::SnapSteps& steps); ///< those not above 0 stay as they are
    void setShowsPath(bool on);
    void setShowsGhosts(bool on);
    void setGhostFrames(const ramure::GhostFrames& frames); ///< clamped
    void setRadians(bool on);

signals:
    void changed();

private:
    template <class T> void set(T& member, const T& value);

    TransformTool m_tool = TransformTool::Select;
    TransformSpace m_space = TransformSpace::World;
    bool m_snaps = false;
    SnapSteps m_steps;
    bool m_path = false;
    bool m_ghosts = false;
    GhostFrames m_ghostFrames;
    bool m_radians = false;
};

} // namespace ramure
