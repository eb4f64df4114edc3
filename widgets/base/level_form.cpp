#include "widgets/base/level_form.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSpinBox>

namespace ramure {

LevelForm::LevelForm(QWidget* parent)
    : QWidget(parent)
    , m_count(new QSpinBox(this))
    , m_label(new QLabel(this))
    , m_budgets(new QLineEdit(this))
{
    m_count->setObjectName(QStringLiteral("exportLevels"));
    m_budgets->setObjectName(QStringLiteral("exportBudgets"));
    m_count->setRange(1, static_cast<int>(mostLevels));
    m_label->setBuddy(m_budgets);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_count);
    row->addSpacing(8);
    row->addWidget(m_label);
    row->addWidget(m_budgets, 1);
    connect(m_count, &QSpinBox::valueChanged, this, &LevelForm::changed);
    connect(m_budgets, &QLineEdit::textChanged, this, &LevelForm::changed);
    setFocusProxy(m_count);
    retranslate();
}

LevelOptions LevelForm::options() const
{
    LevelOptions options;
    // Digits may be grouped, by a space for example: commas and semicolons alone part numbers.
    const QString text = m_budgets->text();
    for (QString budget : text.split(QRegularExpression(QStringLiteral("[,;]")), Qt::SkipEmptyParts))
        if (budget.remove(QRegularExpression(QStringLiteral("\\s"))); !budget.isEmpty())
            options.budgets.push_back(budget.toLongLong());
    if (m_count->value() > 1 || !options.budgets.empty())
        options.count = m_count->value();
    return options;
}

void LevelForm::setOptions(const LevelOptions& options)
{
    QStringList budgets;
    for (const std::int64_t budget : options.budgets)
        budgets += QString::number(budget);
    m_count->setValue(std::max(1, static_cast<int>(options.count)));
    m_budgets->setText(budgets.join(QStringLiteral(", ")));
}

void LevelForm::setNarrow()
{
    m_isNarrow = true;
    retranslate();
}

Expected<void> LevelForm::check() const
{
    static const QRegularExpression numbers(QStringLiteral("^[\\d\\s,;]*$"));
    if (!numbers.match(m_budgets->text()).hasMatch())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("budgets are numbers of triangles, with commas between them"));
    const LevelOptions wanted = options();
    return wanted.isWanted() ? checkLevels(wanted) : Expected<void>();
}

void LevelForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void LevelForm::retranslate()
{
    m_count->setToolTip(
        tr("Meshes of each tree, 1 to 8, for less and less triangles. A GLB holds them all; of other "
           "formats each is a file."));
    m_count->setAccessibleName(tr("Number of levels"));
    m_label->setText(tr("Triangles"));
    m_budgets->setPlaceholderText(m_isNarrow ? tr("as it is, then a quarter", "the tree")
                                             : tr("the tree as it is, then a quarter each"));
    m_budgets->setToolTip(
        tr("Triangles of each level, with commas between them, such as 10000, 2500: bark, leaves and "
           "fruit together, kept within 2 %. Nothing here: the first level is the tree as it is, each "
           "further one has a quarter."));
    m_budgets->setAccessibleName(tr("Triangles of each level"));
}

} // namespace ramure
