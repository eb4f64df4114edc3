/// \file
/// In the status bar while edits made by hand have no branch to act on: how many, and a click lists them.
#pragma once

#include <QToolButton>

namespace ramure {

class Document;

class UnplacedButton : public QToolButton
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the button.
    explicit UnplacedButton(Document* document, QWidget* parent = nullptr);

private:
    void update();

    Document* m_document;
};

} // namespace ramure
