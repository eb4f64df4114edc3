#include "widgets/panels/inspector/fact_form.h"

#include <QGridLayout>
#include <QLabel>

namespace ramure {

FactForm::FactForm(int rows, QWidget* parent)
    : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(0, 3);
    grid->setColumnStretch(1, 4);
    for (int row = 0; row < rows; ++row) {
        auto* name = new QLabel(this);
        name->setForegroundRole(QPalette::PlaceholderText);
        name->setTextFormat(Qt::PlainText);
        name->setWordWrap(true);
        auto* value = new QLabel(this);
        value->setWordWrap(true);
        value->setTextInteractionFlags(Qt::TextBrowserInteraction);
        value->setTextFormat(Qt::PlainText);
        name->setBuddy(value);
        connect(value, &QLabel::linkActivated, this, &FactForm::linkActivated);
        name->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        value->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        grid->addWidget(name, row, 0);
        grid->addWidget(value, row, 1);
        m_names.push_back(name);
        m_values.push_back(value);
    }
}

void FactForm::setName(int row, const QString& name, const QString& help)
{
    const auto at = static_cast<std::size_t>(row);
    m_names[at]->setText(name);
    m_names[at]->setToolTip(help);
    m_values[at]->setToolTip(help);
    m_values[at]->setAccessibleName(name);
}

void FactForm::setValue(int row, const QString& plainText)
{
    QLabel* label = m_values[static_cast<std::size_t>(row)];
    if (label->textFormat() == Qt::PlainText && label->text() == plainText)
        return; // keeps what is marked
    label->setTextFormat(Qt::PlainText);
    label->setText(plainText);
}

void FactForm::setRichValue(int row, const QString& html)
{
    QLabel* label = m_values[static_cast<std::size_t>(row)];
    if (label->textFormat() == Qt::RichText && label->text() == html)
        return;
    label->setTextFormat(Qt::RichText);
    label->setText(html);
}

QString FactForm::value(int row) const
{
    return m_values[static_cast<std::size_t>(row)]->text();
}

QString FactForm::name(int row) const
{
    return m_names[static_cast<std::size_t>(row)]->text();
}

} // namespace ramure
