/// \file
/// Parameters and placements with keys: whether they have any, one at the frame on show, and edits that
/// become keys. The placement of a node that is keyed is what its track makes of it, see
/// core/scene/keyed_placement.h.
#pragma once

#include "core/qt/document/commands.h"
#include "core/qt/document/key_state.h"
#include "core/scene/keyed_placement.h"
#include <QObject>
#include <optional>
#include <utility>
#include <vector>

namespace ramure {

class Player;

class AutoKey : public QObject
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the object.
    AutoKey(Document* document, Player* player, QObject* parent = nullptr);

    [[nodiscard]] Player* player() const { return m_player; }
    [[nodiscard]] bool isOn() const { return m_on; }
    [[nodiscard]] KeyState state(const std::vector<NodeId>& nodes, const ParamDef& def) const;
    /// Returns the parameter's value at the frame on show.
    [[nodiscard]] ParamValue value(NodeId node, const ParamDef& def) const;
    /// An edit of this parameter is to become keys: it has keys, or auto-key is on and it may have some. A
    /// parameter with keys has no other value that would be seen.
    [[nodiscard]] bool takes(const std::vector<NodeId>& nodes, const ParamDef& def) const;
    /// Sets keys at the frame on show, whether there are any yet or not, for one component (0, 1, 2) or all.
    /// Errors: those of checkValue.
    Expected<void> set(const std::vector<NodeId>& nodes, const ParamDef& def, const ParamValue& value,
                       std::optional<int> component, GestureId gesture);
    /// The tracks of a node with keys of all components at the frame on show, for an edit that changes more
    /// than tracks. \pre isKeyable, no placement. Errors: values that are not finite.
    [[nodiscard]] Expected<NodeAnimation> withKeys(const Node& node, const ParamDef& def,
                                                   const ParamValue& value) const;
    /// The button beside the parameter: takes the keys here away, or inserts them.
    Expected<void> toggle(const std::vector<NodeId>& nodes, const ParamDef& def);

    /// \name The same of one channel of a number, as those of an arm's joints
    /// \{
    [[nodiscard]] KeyState state(NodeId node, const Channel& channel) const;
    [[nodiscard]] double value(NodeId node, const Channel& channel) const;
    [[nodiscard]] bool takes(NodeId node, const Channel& channel) const;
    Expected<void> set(NodeId node, const Channel& channel, double value, GestureId gesture);
    /// Keys at the frame on show with these values, whether there are any or not; one step.
    Expected<void> insert(NodeId node, const std::vector<std::pair<Channel, double>>& values,
                          const QString& text, GestureId gesture = 0);
    Expected<void> toggle(NodeId node, const Channel& channel);
    /// \}

public slots:
    void setOn(bool on);

signals:
    void changed(bool on);

private:
    [[nodiscard]] Ticks now() const;
    Expected<void> setPlacement(const std::vector<NodeId>& nodes, const ParamDef& def, PlacementPart part,
                                const glm::dvec3& value, std::optional<int> component, GestureId gesture);

    Document* m_document;
    Player* m_player;
    bool m_on = false;
};

} // namespace ramure
