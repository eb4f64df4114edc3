/// \file
/// Content of the inspector dock: the facts of the active branch, its cross-sections one by one, and the roll
/// of its frames by hand.
#pragma once

#include "core/base/index.h"
#include "core/scene/scene.h"
#include "widgets/base/texts/number_format.h"
#include <QWidget>
#include <memory>

namespace ramure {

class Document;

class BranchInspector : public QWidget
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the inspector.
    explicit BranchInspector(Document* document, QWidget* parent = nullptr);
    ~BranchInspector() override;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

public slots:
    /// Degrees (as at first) or radians.
    void setAngleUnit(ramure::AngleUnit unit);
    void nextSection();
    void previousSection();
    /// To the field of the roll, its value marked: the next key replaces it.
    void focusRoll();
    /// The sections of the active branch, comma-separated, on the clipboard.
    void copyCsv();

signals:
    /// The section to show in the viewport: ViewMarks::inspect. Sent anew whenever its place may
    /// have moved, only while the inspector is visible.
    void sectionInspected(ramure::NodeId node, ramure::Index branch, ramure::Index section);
    /// Nothing to show any more: ViewMarks::inspect with noNode.
    void sectionLeft();
    /// Messages for the status bar: a copied text, the reason against an edit.
    void messageRaised(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
