/// \file
/// Below the choice of a leaf, a fruit, a bark or the picture of another surface in the properties: what it
/// looks like, made in the background while the numbers are dragged.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/jobs/job.h"
#include "core/scene/material.h"
#include <QImage>
#include <QWidget>

class QToolButton;

namespace ramure {

class SurfacePreview : public QWidget
{
    Q_OBJECT
public:
    enum class Surface : std::uint8_t { Leaf, Fruit, Bark, Object };

    /// \param document is not owned and must outlive the preview.
    SurfacePreview(Document* document, Surface surface, QWidget* parent);

    /// The node whose surface is shown; noNode: none, as with several selected.
    void setNode(NodeId node);
    /// Null until the first one is made.
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    [[nodiscard]] QSize sizeHint() const override;
    /// Returns the button that opens the large view of the leaf; null for other surfaces.
    [[nodiscard]] QToolButton* largerButton() const { return m_larger; }

signals:
    /// By the button or a double click.
    void largerRequested();

protected:
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    [[nodiscard]] Material materialOf(const Node& node, bool turns) const;

    void placeButton();

    Document* m_document;
    Surface m_surface;
    NodeId m_node = noNode;
    LeafParams m_leaf;
    FruitParams m_fruit;
    Material m_material;
    bool m_turns = false;
    bool m_isAsked = false; ///< a picture of these was asked for
    QImage m_picture;
    QToolButton* m_larger = nullptr;
    Job m_job;
};

} // namespace ramure
