/// \file
/// The left end of the status bar: what is wrong with the parameters of the active tree; a click goes there.
#pragma once

#include "core/qt/document/document.h"
#include <QToolButton>

namespace ramure {

class ProblemButton : public QToolButton
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the button.
    explicit ProblemButton(Document* document, QWidget* parent = nullptr);

    /// The whole message, empty where all is well.
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// Clicked: \p key of the parameter to blame, empty where there is none.
    void paramRequested(const QString& key);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void update();
    void elide();

    Document* m_document;
    QString m_message;
    NodeId m_node = noNode;
    QString m_key;
};

} // namespace ramure
