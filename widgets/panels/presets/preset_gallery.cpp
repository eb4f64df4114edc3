#include "widgets/panels/presets/preset_gallery.h"

#include "core/presets/presets.h"
#include "core/qt/document/project/own_presets.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/base/texts/search_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/presets/picture_button.h"
#include <QCollator>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

constexpr int gap = 12;
constexpr int usualColumns = 2;

/// All names that it has and what it is like, to search in.
QString searchedText(const Preset& preset)
{
    return searchable(presetNames(preset) + u' ' + presetTip(preset) + u' ' + presetGroupTitle(preset.group));
}

/// What grammars and points are shown with stands before the species among the presets, and behind them here.
std::vector<const Preset*> speciesFirst()
{
    std::vector<const Preset*> all;
    for (const Preset& preset : presets())
        all.push_back(&preset);
    std::rotate(all.begin(), std::ranges::find_if(all, [](const Preset* each) { return isSpecies(*each); }),
                all.end());
    return all;
}

} // namespace

PresetGallery::PresetGallery(int pictureWidth, Preferences* preferences, QWidget* parent)
    : QWidget(parent)
    , m_pictureWidth(pictureWidth)
    , m_preferences(preferences)
    , m_search(named(new QLineEdit(this), "presetSearch"))
    , m_none(named(new QLabel(this), "dim"))
{
    m_search->setClearButtonEnabled(true);
    m_search->setPlaceholderText(tr("Search trees"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_none->setWordWrap(true);
    auto* layout = layoutOf<QVBoxLayout>(this, 6);
    layout->addWidget(m_search);
    layout->addWidget(m_none);
    addGroup(RAMURE_NOOP("Favourites"));
    addGroup(RAMURE_NOOP("Your own"));
    for (const Preset* preset : speciesFirst()) {
        if (m_groups.back().name != std::string_view(preset->group))
            addGroup(preset->group);
        const QString name = QString::fromLatin1(preset->name);
        addPicture(m_groups.back(), name, presetTitle(name), preset);
    }
    const QCollator collator{QLocale()};
    for (Group& group : m_groups)
        if (!group.items.empty() && isSpecies(*group.items.front().preset))
            std::ranges::stable_sort(group.items, [&collator](const Item& a, const Item& b) {
                return collator.compare(a.picture->text(), b.picture->text()) < 0;
            });
    layout->addStretch(1);
    connect(m_search, &QLineEdit::textChanged, this, &PresetGallery::filter);
    connect(m_preferences, &Preferences::changed, this, [this] {
        if (m_favourites != m_preferences->favouritePresets())
            showFavourites();
    });
    showFavourites();
}

void PresetGallery::addGroup(const char* name)
{
    auto* heading = named(new QLabel(presetGroupTitle(name), this), "galleryGroup");
    auto* grid = new QGridLayout;
    grid->setSpacing(gap);
    auto* all = static_cast<QVBoxLayout*>(layout());
    all->addWidget(heading);
    all->addLayout(grid);
    m_groups.push_back({name, heading, grid, {}});
}

/// \param id as namedTree takes it
void PresetGallery::addPicture(Group& group, const QString& id, const QString& name, const Preset* preset)
{
    auto* picture = new PictureButton(id, m_pictureWidth, this);
    picture->setText(name);
    const bool isFavourite = &group == &m_groups.front();
    picture->setObjectName((isFavourite ? QStringLiteral("favourite.") : QStringLiteral("preset.")) + id);
    picture->setStar(isFavourite);
    picture->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(picture, &QAbstractButton::clicked, this, [this, id] { emit chosen(id); });
    connect(picture, &PictureButton::starClicked, this, [this, id] { changeFavourite(id); });
    connect(picture, &QWidget::customContextMenuRequested, this,
            [this, picture](const QPoint& at) { openMenu(picture, at); });
    group.items.push_back({picture, preset});
    describe(group.items.back());
}

void PresetGallery::clear(Group& group)
{
    for (const Item& item : group.items) {
        group.grid->removeWidget(item.picture);
        item.picture->hide();
        item.picture->deleteLater(); // its menu or its star may have been what changed it
    }
    group.items.clear();
}

/// Own ones that are no longer there are passed over, not forgotten: a folder may come back.
void PresetGallery::showFavourites()
{
    m_favourites = m_preferences->favouritePresets();
    Group& favourites = m_groups.front();
    clear(favourites);
    QWidget* before = m_search;
    for (const QString& id : m_favourites) {
        for (std::size_t i = 1; i < m_groups.size(); ++i)
            for (const Item& item : m_groups[i].items) {
                if (item.picture->preset() != id)
                    continue;
                addPicture(favourites, id, item.picture->text(), item.preset);
                favourites.items.back().picture->setPicture(item.picture->picture());
                setTabOrder(before, favourites.items.back().picture);
                before = favourites.items.back().picture;
            }
    }
    for (std::size_t i = 1; i < m_groups.size(); ++i)
        for (const Item& item : m_groups[i].items)
            item.picture->setStar(m_favourites.contains(item.picture->preset()));
    filter();
}

void PresetGallery::changeFavourite(const QString& id)
{
    QStringList favourites = m_preferences->favouritePresets();
    if (favourites.removeAll(id) == 0)
        favourites += id;
    m_preferences->favouritePresets.set(favourites);
}

void PresetGallery::followRename(const QString& from, const QString& to)
{
    QStringList favourites = m_preferences->favouritePresets();
    std::ranges::replace(favourites, from, to);
    m_preferences->favouritePresets.set(favourites);
}

void PresetGallery::showOwn(const OwnPresets& presets)
{
    Group& own = m_groups[1];
    clear(own);
    QWidget* before = m_search;
    for (const QString& name : presets.names()) {
        addPicture(own, QLatin1String(OwnPresets::mark) + name, name, nullptr);
        own.items.back().picture->setPicture(QPixmap(presets.pictureFile(name)));
        setTabOrder(before, own.items.back().picture);
        before = own.items.back().picture;
    }
    showFavourites();
}

QWidget* PresetGallery::first() const
{
    for (const Group& group : m_groups)
        for (const Item& item : group.items)
            if (!item.picture->isHidden())
                return item.picture;
    return nullptr;
}

void PresetGallery::setClickText(const QString& text)
{
    m_clickText = text;
    for (const Group& group : m_groups)
        for (const Item& item : group.items)
            describe(item);
}

void PresetGallery::addChoice(QAction* action, bool own)
{
    (own ? m_ownChoices : m_choices) += action;
}

void PresetGallery::openMenu(PictureButton* picture, const QPoint& at)
{
    m_menuPreset = picture->preset();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(m_choices);
    QAction* star = menu->addAction(tr("&Favourite"), this, [this] { changeFavourite(m_menuPreset); });
    star->setCheckable(true);
    star->setChecked(m_favourites.contains(m_menuPreset));
    if (m_menuPreset.startsWith(QLatin1String(OwnPresets::mark))) {
        menu->addSeparator();
        menu->addActions(m_ownChoices);
    }
    menu->popup(picture->mapToGlobal(at));
}

void PresetGallery::filter()
{
    const QStringList words = searchWords(m_search->text());
    bool any = false;
    for (const Group& group : m_groups) {
        bool some = false;
        for (const Item& item : group.items) {
            const QString text = item.preset ? searchedText(*item.preset) : searchable(item.picture->text());
            const bool hit =
                std::ranges::all_of(words, [&text](const QString& word) { return text.contains(word); });
            item.picture->setVisible(hit);
            some = some || hit;
        }
        group.heading->setVisible(some);
        any = any || some;
    }
    m_none->setVisible(!any);
    m_none->setText(
        tr("No tree is called “%1”. Search for a name, a Latin name or a word of its description.")
            .arg(m_search->text().trimmed()));
    m_columns = 0;
    arrange();
}

/// What is shown, without gaps, in as many columns as there is room for.
void PresetGallery::arrange()
{
    const int columns = std::max(1, (width() + gap) / columnWidth());
    if (columns == m_columns)
        return;
    m_columns = columns;
    for (const Group& group : m_groups) {
        int at = 0;
        for (const Item& item : group.items) {
            group.grid->removeWidget(item.picture);
            if (item.picture->isHidden())
                continue;
            group.grid->addWidget(item.picture, at / columns, at % columns, Qt::AlignLeft | Qt::AlignTop);
            ++at;
        }
        for (int column = 0; column < group.grid->columnCount(); ++column)
            group.grid->setColumnStretch(column, column == columns ? 1 : 0);
        group.grid->setColumnStretch(columns, 1);
    }
}

/// With the gap beside it.
int PresetGallery::columnWidth() const
{
    return m_groups.back().items.front().picture->sizeHint().width() + gap;
}

QSize PresetGallery::sizeHint() const
{
    return {usualColumns * columnWidth() - gap, QWidget::sizeHint().height()};
}

QSize PresetGallery::minimumSizeHint() const
{
    return {columnWidth() - gap, QWidget::minimumSizeHint().height()};
}

void PresetGallery::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void PresetGallery::describe(const Item& item)
{
    const QString what = item.preset ? item.picture->text() + u'\n' + presetTip(*item.preset)
                                     : tr("%1: a tree that you have kept").arg(item.picture->text());
    item.picture->setToolTip(what + u'\n' + m_clickText);
    if (item.preset)
        item.picture->setAccessibleDescription(coreText(item.preset->description));
}

} // namespace ramure
