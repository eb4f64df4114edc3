/// \file
/// What the numbers of Weber and Penn say, drawn beside them: the outline of the crown, and for each level
/// how a stem tapers and bends.
#pragma once

#include "core/qt/document/document.h"
#include <QWidget>
#include <optional>

namespace ramure {

class StemCurves : public QWidget
{
    Q_OBJECT
public:
    /// \param level nothing: the crown. \param document is not owned and must outlive this.
    StemCurves(Document* document, std::optional<std::size_t> level, QWidget* parent);

    /// The tree whose numbers are drawn; noNode: none, as with several selected.
    void setNode(NodeId node);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void refresh();
    void paintCrown(QPainter& painter, const QRectF& field) const;
    void paintStem(QPainter& painter, const QRectF& field) const;

    Document* m_document;
    std::optional<std::size_t> m_level;
    NodeId m_node = noNode;
    std::optional<WeberPennParams> m_params;
};

} // namespace ramure
