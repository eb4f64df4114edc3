#include "widgets/base/empty_page.h"

#include <QLabel>
#include <QVBoxLayout>

namespace ramure {

QString emptySceneText()
{
    return EmptyPage::tr(
        "The scene is empty. Choose a tree in the gallery, use the menu Edit > Add to the scene, "
        "or drop a file onto the window.");
}

EmptyPage::EmptyPage(QWidget* parent)
    : QWidget(parent)
    , m_label(new QLabel(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 32, 24, 24);
    m_label->setObjectName(QStringLiteral("hint"));
    m_label->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_label->setTextFormat(Qt::PlainText);
    m_label->setWordWrap(true);
    layout->addWidget(m_label);
}

void EmptyPage::setText(const QString& text)
{
    m_label->setText(text);
}

QString EmptyPage::text() const
{
    return m_label->text();
}

} // namespace ramure
