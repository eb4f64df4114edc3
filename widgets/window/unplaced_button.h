/// \file
/// In the status bar while edits made by hand have no branch to act on: how many, and a click lists them.
#pragma once

#include <QToolButton>

namespace ramure {

class Document;
class Preferences;

class UnplacedButton : public QToolButton
{
    Q_OBJECT
public:
    /// Neither is owned, and both must outlive the button.
    UnplacedButton(Document* document, const Preferences* preferences, QWidget* parent = nullptr);

private:
    void update();

    Document* m_document;
};

} // namespace ramure
