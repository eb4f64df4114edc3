#include "widgets/panels/properties/group_section.h"

#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/properties/param_row.h"
#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {

GroupSection::GroupSection(const char* group, QWidget* parent)
    : QWidget(parent)
    , m_group(group)
{
    setObjectName(QStringLiteral("group/%1").arg(QString::fromLatin1(group)));
    auto* layout = layoutOf<QVBoxLayout>(this, 0);

    auto* bar = named(new QWidget(this), "groupBar");
    auto* barLayout = layoutOf<QHBoxLayout>(bar, 0);
    m_heading = named(new QToolButton(bar), "groupHeading");
    m_heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_heading->setIconSize({12, 12});
    m_heading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_menuButton = named(new QToolButton(bar), "groupMenu");
    m_menuButton->setAutoRaise(true);
    m_menuButton->setIcon(icon("more"));
    m_menuButton->setIconSize({14, 14});
    m_menuButton->setFocusPolicy(Qt::TabFocus);
    m_menuButton->setPopupMode(QToolButton::InstantPopup);
    m_heading->setAccessibleName(coreText(group));
    m_menuButton->setToolTip(tr("Copy, paste or reset this group"));
    m_menuButton->setAccessibleName(tr("%1: menu").arg(coreText(group)));
    barLayout->addWidget(m_heading, 1);
    barLayout->addWidget(m_menuButton);
    layout->addWidget(bar);

    m_content = new QWidget(this);
    m_contentLayout = layoutOf<QVBoxLayout>(m_content, 6, {12, 6, 8, 10});
    m_advanced = named(new QToolButton(m_content), "advanced");
    m_advanced->setAutoRaise(true);
    m_advanced->setText(tr("More…"));
    m_advanced->hide();
    m_contentLayout->addWidget(m_advanced, 0, Qt::AlignLeft);
    layout->addWidget(m_content);

    buildMenu();
    connect(m_heading, &QToolButton::clicked, this, [this] {
        setFolded(!m_folded);
        emit foldedChanged();
    });
    connect(m_advanced, &QToolButton::clicked, this, [this] {
        m_showAdvanced = !m_showAdvanced;
        m_advanced->setText(m_showAdvanced ? tr("Less") : tr("More…"));
        applyVisibility();
    });
    updateHeading();
}

void GroupSection::buildMenu()
{
    auto* menu = new QMenu(m_menuButton);
    menu->addAction(icon("copy"), tr("Copy values"), this, &GroupSection::copyRequested);
    menu->addAction(icon("paste"), tr("Paste values"), this, &GroupSection::pasteRequested);
    menu->addSeparator();
    QAction* reset = menu->addAction(icon("reset"), tr("Reset values"), this, &GroupSection::resetRequested);
    connect(menu, &QMenu::aboutToShow, this, [this, reset] {
        reset->setEnabled(
            std::ranges::any_of(rowsInReach(), [](const ParamRow* row) { return row->isChanged(); }));
    });
    m_menuButton->setMenu(menu);
}

void GroupSection::addRow(ParamRow* row)
{
    m_rows.push_back(row);
    row->setParent(m_content);
    // Advanced rows stand below the button that shows them.
    const bool advanced = (row->def().flags & paramAdvanced) != 0;
    const int place = advanced ? m_contentLayout->count() : m_contentLayout->indexOf(m_advanced);
    m_contentLayout->insertWidget(place, row);
}

std::vector<ParamRow*> GroupSection::rowsInReach() const
{
    std::vector<ParamRow*> rows = m_rows;
    std::erase_if(rows, [this](const ParamRow* row) { return !row->matches(m_words); });
    return rows;
}

void GroupSection::setFolded(bool folded)
{
    m_folded = folded;
    applyVisibility();
}

int GroupSection::filter(KindBits kinds, const QStringList& words)
{
    const bool isOther = m_words != words;
    m_kinds = kinds;
    m_words = words;
    if (isOther)
        arrange();
    applyVisibility();
    return static_cast<int>(std::ranges::count_if(m_rows, [this](const ParamRow* row) { return fits(row); }));
}

bool GroupSection::fits(const ParamRow* row) const
{
    return (row->def().kinds & m_kinds) == m_kinds && row->isRelevant() && row->matches(m_words);
}

bool GroupSection::isFoundByName() const
{
    return !m_words.isEmpty() && std::ranges::any_of(m_rows, [this](const ParamRow* row) {
        return fits(row) && row->isCalled(m_words);
    });
}

/// While searching by name first; else as in the table, advanced rows below the button that shows them.
void GroupSection::arrange()
{
    std::vector<ParamRow*> rows = m_rows;
    if (!m_words.isEmpty())
        std::stable_partition(rows.begin(), rows.end(),
                              [this](const ParamRow* row) { return row->isCalled(m_words); });
    for (ParamRow* row : rows)
        m_contentLayout->removeWidget(row);
    int place = 0; // above the button
    for (ParamRow* row : rows) {
        const bool below = m_words.isEmpty() && (row->def().flags & paramAdvanced) != 0;
        m_contentLayout->insertWidget(below ? m_contentLayout->count() : place++, row);
    }
}

void GroupSection::applyVisibility()
{
    const bool searching = !m_words.isEmpty();
    bool any = false;
    bool anyAdvanced = false;
    for (ParamRow* row : m_rows) {
        const bool shown = fits(row);
        const bool advanced = (row->def().flags & paramAdvanced) != 0;
        any = any || shown;
        anyAdvanced = anyAdvanced || (shown && advanced);
        row->setVisible(shown && (!advanced || m_showAdvanced || searching));
    }
    setVisible(any && m_kinds != 0);
    m_advanced->setVisible(anyAdvanced && !searching);
    const bool open = !m_folded || searching;
    m_content->setVisible(open);
    m_heading->setIcon(icon(open ? "fold-open" : "fold-closed"));
}

void GroupSection::setMenuShown(bool shown)
{
    m_menuButton->setVisible(shown);
}

void GroupSection::updateHeading()
{
    const auto changed = std::ranges::count_if(m_rows, [](const ParamRow* row) { return row->isChanged(); });
    const QString name = coreText(m_group);
    m_heading->setText(changed > 0 ? QStringLiteral("%1  •").arg(name) : name);
    m_heading->setToolTip(changed > 0 ? tr("%n value(s) changed", nullptr, static_cast<int>(changed))
                                      : tr("No value has been changed"));
}

} // namespace ramure
