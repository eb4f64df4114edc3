/// \file
/// The place of the viewport in the window: the viewport itself where OpenGL 3.3 exists, else a message. The
/// test comes first, because a window that merely contains a QOpenGLWidget crashes on platforms without
/// OpenGL.
#pragma once

#include "widgets/view/view_settings.h"
#include <QWidget>

class QLabel;

namespace ramure {

class Document;
class Viewport;

class ViewportHost : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the host.
    explicit ViewportHost(Document* document, QWidget* parent = nullptr);

    /// Null where there is no OpenGL: actions on it are then disabled.
    [[nodiscard]] Viewport* viewport() const { return m_viewport; }
    /// Always there.
    [[nodiscard]] ViewSettings* settings() const { return m_settings; }

private:
    ViewSettings* m_settings;
    Viewport* m_viewport = nullptr;
};

} // namespace ramure
