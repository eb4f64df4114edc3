/// \file
/// Below the choice of a leaf or a bark in the properties: what it looks like, made in the background while
/// the numbers are dragged.
#pragma once

#include "core/document/document.h"
#include "core/session/job.h"
#include <QImage>
#include <QWidget>
#include <functional>

namespace ramure {

class SurfacePreview : public QWidget
{
    Q_OBJECT
public:
    enum class Surface : std::uint8_t { Leaf, Bark };

    /// \param document is not owned and must outlive the preview.
    SurfacePreview(Document* document, Surface surface, QWidget* parent);

    /// The tree whose surface is shown; noNode: none, as with several selected.
    void setTree(NodeId tree);
    /// Null until the first one is made.
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    void retranslate();

    Document* m_document;
    Surface m_surface;
    NodeId m_tree = noNode;
    LeafParams m_leaf;
    BarkParams m_bark;
    bool m_turns = false;
    bool m_isAsked = false; ///< a picture of these was asked for
    QImage m_picture;
    Job m_job;
};

} // namespace ramure
