/// \file
/// Content of the validation dock. Is the mesh of the selected node (a tree, an arm, a terrain, an object)
/// closed, manifold and oriented, which parts cross, and how well shaped are its triangles? The panel is
/// green, or lists every defect by kind; below follow the mesher's repairs, and the meaning of each kind for
/// a print or a game.
#pragma once

#include "core/scene/scene.h"
#include "widgets/base/defect_place.h"
#include <QWidget>
#include <memory>

namespace ramure {

class Analysis;
class Document;

class ValidationPanel : public QWidget
{
    Q_OBJECT
public:
    /// \param document,analysis are not owned and must outlive the panel. Without an analysis only the
    /// topology of trees is shown. Other nodes are checked here, as long as the panel is visible.
    explicit ValidationPanel(Document* document, QWidget* parent = nullptr);
    ValidationPanel(Document* document, Analysis* analysis, QWidget* parent = nullptr);
    ~ValidationPanel() override;

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

public slots:
    /// The whole report as plain text on the clipboard.
    void copyReport();

signals:
    /// A defect was clicked; its branch is selected by now. Frame place.box, draw the rest.
    void defectActivated(ramure::NodeId node, const ramure::DefectPlace& place);
    /// The highlighted defect is out of date, because another node, another mesh or a repair note is shown.
    /// Or it should be hidden: Escape in the list, or the panel was hidden.
    void defectLeft();
    /// The colliding branches of the tree are to be moved apart.
    void separateRequested(ramure::NodeId tree);
    /// For the status bar.
    void messageRaised(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
