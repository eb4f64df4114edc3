/// \file
/// The text of an empty panel: one calm sentence, centred at the top.
#pragma once

#include <QWidget>

class QLabel;

namespace ramure {

/// Returns the text for the view and the scene panel while the document has no node: what to do first.
QString emptySceneText();

class EmptyPage : public QWidget
{
    Q_OBJECT
public:
    explicit EmptyPage(QWidget* parent);

    /// Plain text, in the interface's language; it wraps.
    void setText(const QString& text);
    [[nodiscard]] QString text() const;

private:
    QLabel* m_label;
};

} // namespace ramure
