/// \file
/// The commands of menus, tool buttons and keys for the selected keys, at the player's playhead. Each is one
/// step of undo, and a refused command says why.
#pragma once

#include "widgets/panels/animation/key_model.h"

namespace ramure {

class Player;

/// The channels that get a key.
enum class KeyParts : std::uint8_t {
    Transform, ///< location, rotation and scale
    Location,
    Rotation,
    Scale,
    Local,    ///< location, rotation and scale of the geometry alone
    Animated, ///< every channel that has keys already
};

enum class KeySnap : std::uint8_t { None, Frame, Second };

class KeyCommands : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the object.
    KeyCommands(KeyModel* model, Player* player, QObject* parent = nullptr);

    [[nodiscard]] Ticks now() const; ///< time of the playhead
    [[nodiscard]] Ticks frameTicks() const;
    [[nodiscard]] bool canPaste() const { return !m_clip.tracks.empty(); }
    [[nodiscard]] KeySnap snapping() const { return m_snap; }
    /// Sets the snapping of dragged keys.
    void setSnapping(KeySnap snap);
    [[nodiscard]] Ticks snapped(Ticks time) const;

    void insert(KeyParts parts);
    void removeAtPlayhead(); ///< keys of the selected nodes
    void remove();
    void duplicate(); ///< right behind the selection, with a frame between
    void copy();
    void cut();
    void paste(bool inPlace);
    void mirror(); ///< about the playhead
    void snap(KeySnap to);
    void nudge(int frames);
    /// Moves keys of a drag in time. \p copies: the old keys stay.
    void retime(const Retiming& retiming, bool copies);
    /// In time, and by each curve's share of \p values.
    void shift(Ticks offset, const std::map<CurveRef, double>& values);
    /// Replaces the key whose handle is dragged: one step per gesture.
    void replaceKey(const TrackRef& ref, const Key& key, GestureId gesture);
    void setMode(KeyMode mode);
    void setEasing(Easing easing);
    void setHandles(HandleType type);
    void extrapolate(bool before, bool behind, Extrapolation extrapolation);
    void selectAll();
    void selectNone();
    void selectColumn(); ///< at the playhead
    void selectBefore(); ///< up to the playhead
    void selectBehind();
    void seekKey(bool forward); ///< the previous or next key in sight

signals:
    void messageRaised(const QString& text);

private:
    [[nodiscard]] Document& document() const { return *m_model->document(); }
    void take(Expected<KeySelection> selection);
    void report(const Expected<void>& done);
    bool hasSelection();

    KeyModel* m_model;
    Player* m_player;
    KeyClip m_clip;
    KeySnap m_snap = KeySnap::Frame;
};

} // namespace ramure
