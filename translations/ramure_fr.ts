<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;New tree</source>
        <translation>&amp;Nouvel arbre</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>Reno&amp;mmer</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Hide or show</source>
        <translation>Masquer ou a&amp;fficher</translation>
    </message>
    <message>
        <source>Loc&amp;k or unlock</source>
        <translation>&amp;Verrouiller ou déverrouiller</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Enregistrer la scène</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>Enregistrer la scène sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>Cadrer &amp;tout</translation>
    </message>
    <message>
        <source>&amp;Frame the selection</source>
        <translation>&amp;Cadrer la sélection</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Face</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Arrière</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>De&amp;ssus</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>D&amp;essous</translation>
    </message>
    <message>
        <source>&amp;Skeleton</source>
        <translation>&amp;Squelette</translation>
    </message>
    <message>
        <source>S&amp;implified skeleton</source>
        <translation>Squelette s&amp;implifié</translation>
    </message>
    <message>
        <source>&amp;Rough model</source>
        <translation>Modèle &amp;ébauché</translation>
    </message>
    <message>
        <source>&amp;Cross-sections</source>
        <translation>Se&amp;ctions</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Maillage</translation>
    </message>
    <message>
        <source>S&amp;olid</source>
        <translation>&amp;Plein</translation>
    </message>
    <message>
        <source>Solid with &amp;edges</source>
        <translation>Plein avec a&amp;rêtes</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Fil de fer</translation>
    </message>
    <message>
        <source>&amp;Leaves</source>
        <translation>Fe&amp;uilles</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Orthographique</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Comme le &amp;système</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>&amp;Degrees</source>
        <translation>&amp;Degrés</translation>
    </message>
    <message>
        <source>&amp;Radians</source>
        <translation>&amp;Radians</translation>
    </message>
    <message>
        <source>Find a &amp;parameter</source>
        <translation>Chercher un &amp;paramètre</translation>
    </message>
    <message>
        <source>Reset the &amp;layout</source>
        <translation>Réinitialiser la &amp;disposition</translation>
    </message>
    <message>
        <source>&amp;About Ramure</source>
        <translation>À &amp;propos de Ramure</translation>
    </message>
    <message>
        <source>Save a &amp;picture…</source>
        <translation>Enregistrer une &amp;image…</translation>
    </message>
    <message>
        <source>Write the view as a picture</source>
        <translation>Écrire la vue sous forme d’image</translation>
    </message>
    <message>
        <source>&amp;Copy the picture</source>
        <translation>&amp;Copier l’image</translation>
    </message>
    <message>
        <source>Put the view on the clipboard as a picture</source>
        <translation>Placer la vue dans le presse-papiers sous forme d’image</translation>
    </message>
    <message>
        <source>Select all &amp;branches</source>
        <translation>Sélectionner toutes les &amp;branches</translation>
    </message>
    <message>
        <source>Select every branch of the active tree</source>
        <translation>Sélectionner toutes les branches de l’arbre actif</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>Ne rien sélecti&amp;onner</translation>
    </message>
    <message>
        <source>&amp;Welcome page</source>
        <translation>Page d’accuei&amp;l</translation>
    </message>
    <message>
        <source>Presets as pictures, recent files, first keys</source>
        <translation>Modèles en images, fichiers récents, premières touches</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation>
    </message>
    <message>
        <source>Theme, language, units, mouse, autosave</source>
        <translation>Thème, langue, unités, souris, enregistrement automatique</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>&amp;Raccourcis clavier…</translation>
    </message>
    <message>
        <source>See and change the keys of all actions</source>
        <translation>Voir et modifier les touches de toutes les actions</translation>
    </message>
    <message>
        <source>&amp;Parents</source>
        <translation>&amp;Parents</translation>
    </message>
    <message>
        <source>Select the parents of the selected branches</source>
        <translation>Sélectionner les branches qui portent les branches sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Children</source>
        <translation>&amp;Enfants</translation>
    </message>
    <message>
        <source>Select the children of the selected branches</source>
        <translation>Sélectionner les branches portées par les branches sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Siblings</source>
        <translation>&amp;Frères</translation>
    </message>
    <message>
        <source>Select all with the same parent</source>
        <translation>Sélectionner tout ce qui a le même parent</translation>
    </message>
    <message>
        <source>Sub&amp;tree</source>
        <translation>&amp;Sous-arbre</translation>
    </message>
    <message>
        <source>Add everything that grows from the selected ones</source>
        <translation>Ajouter tout ce qui pousse sur les éléments sélectionnés</translation>
    </message>
    <message>
        <source>All of the same &amp;order</source>
        <translation>Tout le même &amp;ordre</translation>
    </message>
    <message>
        <source>Select all as deep as the selected ones</source>
        <translation>Sélectionner tout ce qui est à la même profondeur</translation>
    </message>
    <message>
        <source>&amp;Find in the scene</source>
        <translation>&amp;Chercher dans la scène</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Isoler</translation>
    </message>
    <message>
        <source>Sho&amp;w all</source>
        <translation>T&amp;out afficher</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>Copy the na&amp;me</source>
        <translation>Copier le no&amp;m</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>Let the trees move, or pause</source>
        <translation>Fait bouger les arbres, ou marque une pause</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Back to the first frame; pulls and fallen apples are forgotten</source>
        <translation>Revient à la première image ; tractions et pommes tombées sont oubliées</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>Image &amp;suivante</translation>
    </message>
    <message>
        <source>Pre&amp;vious frame</source>
        <translation>Image &amp;précédente</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>P&amp;remière image</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Dernière image</translation>
    </message>
    <message>
        <source>&amp;Every frame</source>
        <translation>&amp;Toutes les images</translation>
    </message>
    <message>
        <source>Show all frames, if need be slower; off: keep time and drop frames that come too late</source>
        <translation>Montre toutes les images, au besoin plus lentement ; désactivé : garde la cadence et saute les images en retard</translation>
    </message>
    <message>
        <source>Play &amp;once</source>
        <translation>Une &amp;fois</translation>
    </message>
    <message>
        <source>Stop at the last frame</source>
        <translation>S&apos;arrête à la dernière image</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>En &amp;boucle</translation>
    </message>
    <message>
        <source>Go on with the first frame after the last</source>
        <translation>Reprend à la première image après la dernière</translation>
    </message>
    <message>
        <source>P&amp;ing-pong</source>
        <translation>&amp;Aller-retour</translation>
    </message>
    <message>
        <source>Play forwards and back again</source>
        <translation>Joue en avant puis en arrière</translation>
    </message>
    <message>
        <source>Ne&amp;xt section</source>
        <translation>Section &amp;suivante</translation>
    </message>
    <message>
        <source>Inspect the next cross-section of the branch</source>
        <translation>Inspecter la section suivante de la branche</translation>
    </message>
    <message>
        <source>P&amp;revious section</source>
        <translation>Section p&amp;récédente</translation>
    </message>
    <message>
        <source>Inspect the cross-section before this one</source>
        <translation>Inspecter la section qui précède</translation>
    </message>
    <message>
        <source>Roll by h&amp;and</source>
        <translation>&amp;Rouler à la main</translation>
    </message>
    <message>
        <source>Turn the frames of the selected branches</source>
        <translation>Tourner les repères des branches sélectionnées</translation>
    </message>
    <message>
        <source>Show only the selected branches, or nodes; again: show all</source>
        <translation>Montrer seulement les branches ou les nœuds sélectionnés ; de nouveau : tout montrer</translation>
    </message>
    <message>
        <source>Orbit &amp;left</source>
        <translation>Tourner à &amp;gauche</translation>
    </message>
    <message>
        <source>Orbit &amp;right</source>
        <translation>Tourner à &amp;droite</translation>
    </message>
    <message>
        <source>Orbit &amp;up</source>
        <translation>Tourner vers le &amp;haut</translation>
    </message>
    <message>
        <source>Orbit &amp;down</source>
        <translation>Tourner vers le &amp;bas</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Rapprocher</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Éloigner</translation>
    </message>
    <message>
        <source>Move colliding branches a&amp;part…</source>
        <translation>É&amp;carter les branches qui se heurtent…</translation>
    </message>
    <message>
        <source>Chec&amp;ker of the texture</source>
        <translation>&amp;Damier de la texture</translation>
    </message>
    <message>
        <source>S&amp;tretch of the texture</source>
        <translation>Éti&amp;rement de la texture</translation>
    </message>
    <message>
        <source>S&amp;hake off an apple</source>
        <translation>&amp;Faire tomber une pomme</translation>
    </message>
    <message>
        <source>While playing, the next apple of the active tree falls; or double-click on one</source>
        <translation>Pendant la lecture, la pomme suivante de l&apos;arbre actif tombe ; ou double-cliquez sur une pomme</translation>
    </message>
    <message>
        <source>&amp;Wind arrow</source>
        <translation>Flèche du &amp;vent</translation>
    </message>
    <message>
        <source>&amp;Bake the motion</source>
        <translation>Pré&amp;calculer le mouvement</translation>
    </message>
    <message>
        <source>Compute all frames of the range and keep them beside the project; pulls and fallen apples are not kept</source>
        <translation>Calcule toutes les images de la plage et les garde à côté du projet ; tractions et pommes tombées ne sont pas gardées</translation>
    </message>
    <message>
        <source>F&amp;ree the baked motion</source>
        <translation>Li&amp;bérer le mouvement précalculé</translation>
    </message>
    <message>
        <source>Delete the project&apos;s baked motion from the disk</source>
        <translation>Supprime du disque le mouvement précalculé du projet</translation>
    </message>
    <message>
        <source>Write meshes, sequences of frames or pictures</source>
        <translation>Écrire des maillages, des suites d’images animées ou des vues</translation>
    </message>
    <message>
        <source>&amp;Insert key</source>
        <translation>&amp;Insérer une clé</translation>
    </message>
    <message>
        <source>&amp;Remove key here</source>
        <translation>&amp;Retirer la clé ici</translation>
    </message>
    <message>
        <source>Take out all keys that the selected nodes have at this frame</source>
        <translation>Retire toutes les clés que les nœuds sélectionnés ont à cette image</translation>
    </message>
    <message>
        <source>Pre&amp;vious key</source>
        <translation>Clé &amp;précédente</translation>
    </message>
    <message>
        <source>Go to the key before this frame</source>
        <translation>Va à la clé avant cette image</translation>
    </message>
    <message>
        <source>&amp;Next key</source>
        <translation>Clé sui&amp;vante</translation>
    </message>
    <message>
        <source>Go to the key behind this frame</source>
        <translation>Va à la clé après cette image</translation>
    </message>
    <message>
        <source>&amp;Rotation</source>
        <translation>&amp;Rotation</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Échelle</translation>
    </message>
    <message>
        <source>&amp;Geometry alone</source>
        <translation>&amp;Géométrie seule</translation>
    </message>
    <message>
        <source>&amp;All that has keys</source>
        <translation>&amp;Tout ce qui a des clés</translation>
    </message>
    <message>
        <source>A key in every channel of the selected nodes that has keys already</source>
        <translation>Une clé dans chaque canal des nœuds sélectionnés qui a déjà des clés</translation>
    </message>
    <message>
        <source>&amp;Duplicate keys</source>
        <translation>&amp;Dupliquer les clés</translation>
    </message>
    <message>
        <source>Copies right behind the selected keys; in the dope sheet Ctrl+D, or Ctrl+drag to any place</source>
        <translation>Copies juste après les clés sélectionnées ; dans la feuille de clés Ctrl+D, ou glisser avec Ctrl n’importe où</translation>
    </message>
    <message>
        <source>C&amp;ut keys</source>
        <translation>Co&amp;uper les clés</translation>
    </message>
    <message>
        <source>In the dope sheet Ctrl+X</source>
        <translation>Dans la feuille de clés Ctrl+X</translation>
    </message>
    <message>
        <source>&amp;Copy keys</source>
        <translation>&amp;Copier les clés</translation>
    </message>
    <message>
        <source>In the dope sheet Ctrl+C</source>
        <translation>Dans la feuille de clés Ctrl+C</translation>
    </message>
    <message>
        <source>&amp;Paste keys</source>
        <translation>C&amp;oller les clés</translation>
    </message>
    <message>
        <source>The first key comes to the frame on show; in the dope sheet Ctrl+V</source>
        <translation>La première clé vient à l’image affichée ; dans la feuille de clés Ctrl+V</translation>
    </message>
    <message>
        <source>Paste keys in p&amp;lace</source>
        <translation>Coller les clés sur p&amp;lace</translation>
    </message>
    <message>
        <source>At the times they were copied from; in the dope sheet Ctrl+Shift+V</source>
        <translation>Aux moments d’où elles viennent ; dans la feuille de clés Ctrl+Maj+V</translation>
    </message>
    <message>
        <source>&amp;Mirror keys</source>
        <translation>&amp;Mettre les clés en miroir</translation>
    </message>
    <message>
        <source>Backwards, about the frame on show; in the dope sheet Ctrl+M</source>
        <translation>À rebours, autour de l’image affichée ; dans la feuille de clés Ctrl+M</translation>
    </message>
    <message>
        <source>Move to the nearest &amp;frames</source>
        <translation>Déplacer aux images les plus proc&amp;hes</translation>
    </message>
    <message>
        <source>Move to the nearest &amp;seconds</source>
        <translation>Déplacer aux &amp;secondes les plus proches</translation>
    </message>
    <message>
        <source>D&amp;elete keys</source>
        <translation>Supprim&amp;er les clés</translation>
    </message>
    <message>
        <source>In the dope sheet Del</source>
        <translation>Dans la feuille de clés Suppr</translation>
    </message>
    <message>
        <source>&amp;All keys</source>
        <translation>&amp;Toutes les clés</translation>
    </message>
    <message>
        <source>In the dope sheet Ctrl+A</source>
        <translation>Dans la feuille de clés Ctrl+A</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Aucune clé</translation>
    </message>
    <message>
        <source>In the dope sheet Esc</source>
        <translation>Dans la feuille de clés Échap</translation>
    </message>
    <message>
        <source>All at this &amp;frame</source>
        <translation>Toutes à cette &amp;image</translation>
    </message>
    <message>
        <source>In the dope sheet K, or Alt+click on a key</source>
        <translation>Dans la feuille de clés K, ou Alt+clic sur une clé</translation>
    </message>
    <message>
        <source>All &amp;up to this frame</source>
        <translation>Toutes &amp;jusqu’à cette image</translation>
    </message>
    <message>
        <source>In the dope sheet [</source>
        <translation>Dans la feuille de clés [</translation>
    </message>
    <message>
        <source>All f&amp;rom this frame on</source>
        <translation>Toutes à &amp;partir de cette image</translation>
    </message>
    <message>
        <source>In the dope sheet ]</source>
        <translation>Dans la feuille de clés ]</translation>
    </message>
    <message>
        <source>Auto-ke&amp;y</source>
        <translation>Clés automati&amp;ques</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Import &amp;folder…</source>
        <translation>Importer un &amp;dossier…</translation>
    </message>
    <message>
        <source>Add all objects of a folder that a script for Blender wrote</source>
        <translation>Ajouter tous les objets d&apos;un dossier écrit par un script pour Blender</translation>
    </message>
    <message>
        <source>G&amp;round</source>
        <translation>So&amp;l</translation>
    </message>
    <message>
        <source>Hide the ground to see objects below it</source>
        <translation>Masquer le sol pour voir ce qui est en dessous</translation>
    </message>
    <message>
        <source>&amp;Select tool</source>
        <translation>Outil &amp;Sélectionner</translation>
    </message>
    <message>
        <source>Select nodes and branches; no handles</source>
        <translation>Sélectionner des nœuds et des branches ; sans poignées</translation>
    </message>
    <message>
        <source>M&amp;ove tool</source>
        <translation>Outil Dé&amp;placer</translation>
    </message>
    <message>
        <source>Handles that move the selected nodes. Ctrl: in steps, Shift: finely</source>
        <translation>Des poignées qui déplacent les nœuds sélectionnés. Ctrl : par pas, Maj : finement</translation>
    </message>
    <message>
        <source>Ro&amp;tate tool</source>
        <translation>Outil To&amp;urner</translation>
    </message>
    <message>
        <source>Rings that turn the selected nodes. Ctrl: in steps, Shift: finely</source>
        <translation>Des anneaux qui tournent les nœuds sélectionnés. Ctrl : par pas, Maj : finement</translation>
    </message>
    <message>
        <source>Sc&amp;ale tool</source>
        <translation>Outil Mettre à l’é&amp;chelle</translation>
    </message>
    <message>
        <source>Boxes that scale the selected nodes. Ctrl: in steps, Shift: finely</source>
        <translation>Des cubes qui mettent les nœuds sélectionnés à l’échelle. Ctrl : par pas, Maj : finement</translation>
    </message>
    <message>
        <source>&amp;Local axes</source>
        <translation>Axes &amp;locaux</translation>
    </message>
    <message>
        <source>Axes of the &amp;parent</source>
        <translation>Axes du pa&amp;rent</translation>
    </message>
    <message>
        <source>Axes of the &amp;world</source>
        <translation>Axes du &amp;monde</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Déplacer</translation>
    </message>
    <message>
        <source>Move with the mouse, or type: X 1.5 Enter</source>
        <translation>Déplacer avec la souris, ou taper : X 1.5 Entrée</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>&amp;Tourner</translation>
    </message>
    <message>
        <source>Rotate with the mouse, or type: Y 90 Enter</source>
        <translation>Tourner avec la souris, ou taper : Y 90 Entrée</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>Mettre à l’éch&amp;elle</translation>
    </message>
    <message>
        <source>Scale with the mouse, or type: 2 Enter</source>
        <translation>Mettre à l’échelle avec la souris, ou taper : 2 Entrée</translation>
    </message>
    <message>
        <source>S&amp;nap to steps</source>
        <translation>Aller par &amp;pas</translation>
    </message>
    <message>
        <source>Dragged values go in steps; Ctrl while dragging: the other way round</source>
        <translation>Les valeurs changent par pas ; Ctrl pendant le geste : l’inverse</translation>
    </message>
    <message>
        <source>Motion &amp;path</source>
        <translation>Traj&amp;ectoire</translation>
    </message>
    <message>
        <source>The way of the selected nodes over all frames, with its keys</source>
        <translation>Le chemin des nœuds sélectionnés sur toutes les images, avec ses clés</translation>
    </message>
    <message>
        <source>G&amp;hosts</source>
        <translation>Fantô&amp;mes</translation>
    </message>
    <message>
        <source>Translucent copies of the selected nodes at frames before and after this one</source>
        <translation>Des copies translucides des nœuds sélectionnés, à des images avant et après celle-ci</translation>
    </message>
    <message>
        <source>Steps and &amp;ghosts…</source>
        <translation>Pas et &amp;fantômes…</translation>
    </message>
    <message>
        <source>Snapping steps and number of ghosts</source>
        <translation>Pas d’aimantation et nombre de fantômes</translation>
    </message>
    <message>
        <source>Frame all that is shown, wherever keys move it to on the timeline</source>
        <translation>Cadrer tout ce qui est affiché, où que les clés l’emmènent sur la ligne de temps</translation>
    </message>
    <message>
        <source>Frame the selected branches or nodes as they stand now, or everything where none is selected</source>
        <translation>Cadrer les branches ou les nœuds sélectionnés tels qu’ils sont maintenant, ou tout si rien n’est sélectionné</translation>
    </message>
    <message>
        <source>Sea&amp;mless loop</source>
        <translation>Boucle sans &amp;raccord</translation>
    </message>
    <message>
        <source>Blend the last second of the loop into its first frame, so that trees and arms go on without a jump</source>
        <translation>Fond la dernière seconde de la boucle dans sa première image : les arbres et les bras continuent sans saut</translation>
    </message>
    <message>
        <source>&amp;Find anything…</source>
        <translation>&amp;Tout chercher…</translation>
    </message>
    <message>
        <source>Finds every command, parameter and page of the handbook</source>
        <translation>Trouve toutes les commandes, tous les paramètres et toutes les pages du manuel</translation>
    </message>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>Explains the parameter or panel under the mouse</source>
        <translation>Explique le paramètre ou le panneau sous la souris</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>Five steps through the window</source>
        <translation>Cinq étapes à travers la fenêtre</translation>
    </message>
    <message>
        <source>Keys of position, rotation and scale of the selected nodes, at the frame on show</source>
        <translation>Clés de position, rotation et échelle des nœuds sélectionnés, à l’image affichée</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Position</translation>
    </message>
    <message>
        <source>Position, rotation and scale that children do not follow</source>
        <translation>Position, rotation et échelle que les enfants ne suivent pas</translation>
    </message>
    <message>
        <source>Strai&amp;ghten branches</source>
        <translation>&amp;Redresser les branches</translation>
    </message>
    <message>
        <source>Take back how the selected branches were bent</source>
        <translation>Annuler la courbure des branches sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Inspect the branch</source>
        <translation>&amp;Inspecter la branche</translation>
    </message>
    <message>
        <source>Show the facts and sections of the branch</source>
        <translation>Montrer les mesures et les sections de la branche</translation>
    </message>
    <message>
        <source>Copy with everything below; the copy follows the mouse: a click puts it down, Esc leaves it in place</source>
        <translation>Copier avec tout ce qui est dessous ; la copie suit la souris : un clic la pose, Échap la laisse en place</translation>
    </message>
    <message>
        <source>The branches as lines, as the grammar grew them</source>
        <translation>Les branches en lignes, telles que la grammaire les a fait pousser</translation>
    </message>
    <message>
        <source>The skeleton of the mesh: branches as lines, with straight runs joined</source>
        <translation>Le squelette du maillage : les branches en lignes, les suites droites réunies</translation>
    </message>
    <message>
        <source>A plain tube for each branch</source>
        <translation>Un simple tube par branche</translation>
    </message>
    <message>
        <source>The cross-sections between which the mesh is stretched</source>
        <translation>Les sections entre lesquelles le maillage est tendu</translation>
    </message>
    <message>
        <source>The surface as it is exported</source>
        <translation>La surface telle qu’elle est exportée</translation>
    </message>
    <message>
        <source>A checker on the surface shows how the texture lies</source>
        <translation>Un damier sur la surface montre comment la texture se pose</translation>
    </message>
    <message>
        <source>Colours show where the texture is stretched</source>
        <translation>Des couleurs montrent où la texture est étirée</translation>
    </message>
    <message>
        <source>O&amp;pposite side</source>
        <translation>Côté o&amp;pposé</translation>
    </message>
    <message>
        <source>Look from the other side: from the front becomes from the back, from above from below</source>
        <translation>Regarde de l&apos;autre côté : de face devient de dos, d&apos;en haut devient d&apos;en bas</translation>
    </message>
    <message>
        <source>Show the wind of the active tree, and of all that have some, as arrows; drag a head to turn and strengthen the wind</source>
        <translation>Montre par des flèches le vent de l&apos;arbre actif et de tous ceux qui en ont ; tirez une pointe pour tourner et renforcer le vent</translation>
    </message>
    <message>
        <source>O&amp;utline of the selection</source>
        <translation>Conto&amp;ur de la sélection</translation>
    </message>
    <message>
        <source>Open a Ramure file, or objects into a new scene</source>
        <translation>Ouvrir un fichier Ramure, ou des objets dans une nouvelle scène</translation>
    </message>
    <message>
        <source>L&amp;ight and backdrop…</source>
        <translation>Lum&amp;ière et fond…</translation>
    </message>
    <message>
        <source>Position of the sun and background of the scene</source>
        <translation>Position du soleil et arrière-plan de la scène</translation>
    </message>
    <message>
        <source>&amp;Draft quality</source>
        <translation>Qualité &amp;brouillon</translation>
    </message>
    <message>
        <source>Sun and sky light alone</source>
        <translation>Le soleil et la lumière du ciel seuls</translation>
    </message>
    <message>
        <source>Goo&amp;d quality</source>
        <translation>&amp;Bonne qualité</translation>
    </message>
    <message>
        <source>Crowns are darker inside, while nothing moves</source>
        <translation>L&apos;intérieur des houppiers est plus sombre, tant que rien ne bouge</translation>
    </message>
    <message>
        <source>&amp;Best quality</source>
        <translation>&amp;Meilleure qualité</translation>
    </message>
    <message>
        <source>Smooth edges and soft shadows, while nothing moves</source>
        <translation>Bords lisses et ombres douces, tant que rien ne bouge</translation>
    </message>
    <message>
        <source>Grow another tree from the same rules and numbers, with another seed</source>
        <translation>Faire pousser un autre arbre des mêmes règles et nombres, avec une autre graine</translation>
    </message>
    <message>
        <source>&amp;Crown to fill</source>
        <translation>&amp;Houppier à remplir</translation>
    </message>
    <message>
        <source>The envelope and the points that a selected tree fills when it grows by space colonisation</source>
        <translation>L’enveloppe et les points qu’un arbre sélectionné remplit quand il pousse par colonisation de l’espace</translation>
    </message>
    <message>
        <source>&amp;Look through the camera</source>
        <translation>&amp;Regarder par la caméra</translation>
    </message>
    <message>
        <source>The view becomes that of the selected camera, or of the first one, until the view is moved</source>
        <translation>La vue devient celle de la caméra sélectionnée, ou de la première, jusqu’à ce qu’on la bouge</translation>
    </message>
    <message>
        <source>&amp;Move the camera here</source>
        <translation>&amp;Amener la caméra ici</translation>
    </message>
    <message>
        <source>The selected camera, or the first one, comes to where the view is seen from</source>
        <translation>La caméra sélectionnée, ou la première, vient là d’où l’on regarde</translation>
    </message>
    <message>
        <source>Pac&amp;k pictures</source>
        <translation>Emba&amp;ller les images</translation>
    </message>
    <message>
        <source>Copy all image files that the scene uses into a folder beside the project, to give both away</source>
        <translation>Copier tous les fichiers d’image de la scène dans un dossier à côté du projet, pour donner les deux</translation>
    </message>
    <message>
        <source>M&amp;ore like this…</source>
        <translation>D’autres se&amp;mblables…</translation>
    </message>
    <message>
        <source>Nine trees of the same numbers that chance grew otherwise, to choose from</source>
        <translation>Neuf arbres de mêmes valeurs que le hasard a fait pousser autrement, au choix</translation>
    </message>
    <message>
        <source>Add objects to the scene: meshes, keys from Blender, trees of Arbaro and ez-tree</source>
        <translation>Ajouter des objets à la scène : maillages, clés de Blender, arbres d’Arbaro et d’ez-tree</translation>
    </message>
    <message>
        <source>Removes everything except the limb of the active branch, its twigs and the wood down to the ground</source>
        <translation>Retire tout sauf la branche active, ses rameaux et le bois jusqu’au sol</translation>
    </message>
    <message>
        <source>Leaves of the l&amp;imb on or off</source>
        <translation>Feuilles de la branche &amp;ou non</translation>
    </message>
    <message>
        <source>The leaves of the selected limbs go, or come back</source>
        <translation>Les feuilles des branches sélectionnées s’en vont ou reviennent</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Couper</translation>
    </message>
    <message>
        <source>&amp;Saw</source>
        <translation>&amp;Scier</translation>
    </message>
    <message>
        <source>Draw a line through twigs: all that it crosses is cut there</source>
        <translation>Tracer une ligne à travers les rameaux : tout ce qu’elle croise y est coupé</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Enlever</translation>
    </message>
    <message>
        <source>Click a limb: it goes, with all that grows on it</source>
        <translation>Cliquer sur une branche : elle s’en va, avec tout ce qui pousse dessus</translation>
    </message>
    <message>
        <source>&amp;Keep only</source>
        <translation>&amp;Ne garder que</translation>
    </message>
    <message>
        <source>Click a limb to remove everything except it, its twigs and the wood down to the ground</source>
        <translation>Cliquer sur une branche pour tout retirer sauf elle, ses rameaux et le bois jusqu’au sol</translation>
    </message>
    <message>
        <source>&amp;Bend</source>
        <translation>&amp;Plier</translation>
    </message>
    <message>
        <source>Drag a branch: the limb follows the hand</source>
        <translation>Glisser une branche : elle suit la main</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Longueur</translation>
    </message>
    <message>
        <source>Drag a branch along itself: longer or shorter</source>
        <translation>Glisser une branche le long d’elle-même : plus longue ou plus courte</translation>
    </message>
    <message>
        <source>Drag a branch to the right: thicker, to the left: thinner</source>
        <translation>Glisser une branche à droite : plus épaisse, à gauche : plus mince</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>&amp;Dessiner</translation>
    </message>
    <message>
        <source>Drag from a branch or the ground: a branch grows along the stroke</source>
        <translation>Glisser à partir d’une branche ou du sol : une branche pousse le long du trait</translation>
    </message>
    <message>
        <source>&amp;Graft</source>
        <translation>&amp;Greffer</translation>
    </message>
    <message>
        <source>Click a limb to copy it, then click its new place</source>
        <translation>Cliquer sur une branche pour la copier, puis sur sa nouvelle place</translation>
    </message>
    <message>
        <source>&amp;Prune to a shape</source>
        <translation>&amp;Tailler en forme</translation>
    </message>
    <message>
        <source>Drag a shape around the tree: the wood outside it is cut</source>
        <translation>Tirer une forme autour de l’arbre : le bois qui en dépasse est coupé</translation>
    </message>
    <message>
        <source>L&amp;eaves on or off</source>
        <translation>&amp;Feuilles ou non</translation>
    </message>
    <message>
        <source>Click a limb: its leaves go, or come back</source>
        <translation>Cliquer sur une branche : ses feuilles s’en vont ou reviennent</translation>
    </message>
    <message>
        <source>C&amp;url</source>
        <translation>&amp;Enrouler</translation>
    </message>
    <message>
        <source>Drag a branch to one side: the limb rolls up that way</source>
        <translation>Glissez une branche vers un côté : elle s’enroule par là</translation>
    </message>
    <message>
        <source>Drag a branch to the right or left: its twigs turn about it</source>
        <translation>Glissez une branche à droite ou à gauche : ses rameaux tournent autour d’elle</translation>
    </message>
    <message>
        <source>T&amp;aper</source>
        <translation>E&amp;ffiler</translation>
    </message>
    <message>
        <source>Drag a branch to the right: its tip gets thicker, to the left: thinner</source>
        <translation>Glissez une branche à droite : son bout s’épaissit, à gauche : il s’amincit</translation>
    </message>
    <message>
        <source>E&amp;xtend</source>
        <translation>Pr&amp;olonger</translation>
    </message>
    <message>
        <source>Drag a branch: its tip grows on along the stroke</source>
        <translation>Glissez une branche : son bout pousse le long du trait</translation>
    </message>
    <message>
        <source>Redra&amp;w</source>
        <translation>&amp;Redessiner</translation>
    </message>
    <message>
        <source>Draw over a branch: from there on it goes along the stroke</source>
        <translation>Dessinez sur une branche : à partir de là, elle suit le trait</translation>
    </message>
    <message>
        <source>&amp;Twist</source>
        <translation>&amp;Tordre</translation>
    </message>
    <message>
        <source>&amp;Move the fork</source>
        <translation>Dépla&amp;cer la fourche</translation>
    </message>
    <message>
        <source>Drag a branch: its fork slides along its parent</source>
        <translation>Glissez une branche : sa fourche glisse le long de son parent</translation>
    </message>
    <message>
        <source>Brus&amp;h</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>Drag over branches: they are combed, drawn near or pushed away, or lose their leaves</source>
        <translation>Glissez sur des branches : elles sont peignées, attirées ou repoussées, ou perdent leurs feuilles</translation>
    </message>
    <message>
        <source>Move the r&amp;oot</source>
        <translation>Déplacer la &amp;racine</translation>
    </message>
    <message>
        <source>Drag a tree: its foot goes over the ground, and flares by the wheel</source>
        <translation>Glissez un arbre : son pied va sur le sol, et s’évase par la molette</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exporter à &amp;nouveau</translation>
    </message>
    <message>
        <source>Write the last export once more, over its files</source>
        <translation>Réécrire le dernier export par-dessus ses fichiers</translation>
    </message>
    <message>
        <source>Keep onl&amp;y this limb</source>
        <translation>Ne garder que cette &amp;branche</translation>
    </message>
    <message>
        <source>Thick&amp;ness</source>
        <translation>&amp;Épaisseur</translation>
    </message>
    <message>
        <source>Place a lea&amp;f or fruit</source>
        <translation>Poser une &amp;feuille ou un fruit</translation>
    </message>
    <message>
        <source>Click a branch: one leaf, fruit or flower grows there</source>
        <translation>Cliquez sur une branche : une feuille, un fruit ou une fleur y pousse</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>&amp;Variations…</translation>
    </message>
    <message>
        <source>Many trees from this one, by seeds and ranges of parameters: look at them, star the good ones, write a table for a batch</source>
        <translation>De nombreux arbres à partir de celui-ci, par graines et plages de paramètres : les regarder, marquer les bons d’une étoile, écrire un tableau pour un lot</translation>
    </message>
    <message>
        <source>Cut a branch where you click: the part above disappears, or falls</source>
        <translation>Couper une branche à l’endroit du clic : la partie au-dessus disparaît, ou tombe</translation>
    </message>
    <message>
        <source>F&amp;ruit</source>
        <translation>&amp;Fruits</translation>
    </message>
    <message>
        <source>A changed parameter without keys gets one, too</source>
        <translation>Un paramètre modifié qui n’a pas de clé en reçoit une aussi</translation>
    </message>
    <message>
        <source>&amp;Billboard…</source>
        <translation>&amp;Billboard…</translation>
    </message>
    <message>
        <source>Write crossed cards or an atlas of views, which stand for trees far away</source>
        <translation>Écrire des cartes croisées ou un atlas de vues, qui tiennent lieu d’arbres lointains</translation>
    </message>
    <message>
        <source>&amp;Off</source>
        <translation>Aucu&amp;n</translation>
    </message>
    <message>
        <source>&amp;Any shader (_WIND)</source>
        <translation>T&amp;out shader (_WIND)</translation>
    </message>
    <message>
        <source>Trees at rest move as a shader moves them that reads the attribute _WIND</source>
        <translation>Les arbres au repos bougent comme un shader qui lit l’attribut _WIND les fait bouger</translation>
    </message>
    <message>
        <source>&amp;CryEngine</source>
        <translation>&amp;CryEngine</translation>
    </message>
    <message>
        <source>Trees at rest move as CryEngine moves them by the colours of vertices</source>
        <translation>Les arbres au repos bougent comme CryEngine les fait bouger par les couleurs des sommets</translation>
    </message>
    <message>
        <source>&amp;Unity</source>
        <translation>&amp;Unity</translation>
    </message>
    <message>
        <source>Trees at rest move as the shader of Unity&apos;s Tree Creator moves them</source>
        <translation>Les arbres au repos bougent comme le shader de Tree Creator d’Unity les fait bouger</translation>
    </message>
    <message>
        <source>U&amp;nreal (Pivot Painter 2)</source>
        <translation>Un&amp;real (Pivot Painter 2)</translation>
    </message>
    <message>
        <source>Trees at rest move as the foliage shader of the Unreal Engine moves them</source>
        <translation>Les arbres au repos bougent comme le shader de feuillage d’Unreal Engine les fait bouger</translation>
    </message>
    <message>
        <source>&amp;Breeze (0.3)</source>
        <translation>&amp;Brise (0,3)</translation>
    </message>
    <message>
        <source>Three tenths of a strong wind</source>
        <translation>Trois dixièmes d’un vent fort</translation>
    </message>
    <message>
        <source>&amp;Wind (0.6)</source>
        <translation>&amp;Vent (0,6)</translation>
    </message>
    <message>
        <source>Six tenths of a strong wind</source>
        <translation>Six dixièmes d’un vent fort</translation>
    </message>
    <message>
        <source>&amp;Strong wind (1)</source>
        <translation>Vent &amp;fort (1)</translation>
    </message>
    <message>
        <source>The top of a tree leans by a tenth of its height</source>
        <translation>La cime penche d’un dixième de la hauteur</translation>
    </message>
    <message>
        <source>Lay the tool down; without one, go from branches to their tree, and from there to nothing</source>
        <translation>Pose l’outil ; sans outil, passe des branches à leur arbre, puis à rien</translation>
    </message>
    <message>
        <source>An orange outline around the selection. For a second after a selection it shows through leaves and branches</source>
        <translation>Un contour orange autour de la sélection. Il se voit à travers feuilles et branches pendant une seconde après la sélection</translation>
    </message>
    <message>
        <source>New e&amp;mpty scene</source>
        <translation>Nouvelle scène &amp;vide</translation>
    </message>
    <message>
        <source>Begin a scene with nothing in it</source>
        <translation>Commencer une scène sans rien dedans</translation>
    </message>
    <message>
        <source>&amp;Person of 1.8 m</source>
        <translation>&amp;Personne de 1,8 m</translation>
    </message>
    <message>
        <source>A person beside the first tree, to see how large it is</source>
        <translation>Une personne à côté du premier arbre, pour voir sa taille</translation>
    </message>
    <message>
        <source>S&amp;ky picture…</source>
        <translation>Image du &amp;ciel…</translation>
    </message>
    <message>
        <source>An own picture all around (HDR or EXR) as background, sun and light</source>
        <translation>Une image à vous tout autour (HDR ou EXR) comme fond, soleil et lumière</translation>
    </message>
    <message>
        <source>Tape m&amp;easure</source>
        <translation>&amp;Mètre ruban</translation>
    </message>
    <message>
        <source>Click or drag from one place to another: how far they are from each other, in metres. Over a branch: its diameter</source>
        <translation>Cliquez ou glissez d’un endroit à un autre : leur distance en mètres. Sur une branche : son diamètre</translation>
    </message>
    <message>
        <source>Grass and &amp;fallen leaves</source>
        <translation>Herbe et &amp;feuilles mortes</translation>
    </message>
    <message>
        <source>Grass and fallen leaves on the ground around trees that stand on roots. They are not exported</source>
        <translation>L’herbe et les feuilles mortes au sol, autour des arbres qui ont des racines. Elles ne sont pas exportées</translation>
    </message>
</context>
<context>
    <name>ArmOverlay</name>
    <message>
        <source>unreachable: %1 m short</source>
        <translation>hors d&apos;atteinte : il manque %1 m</translation>
    </message>
    <message>
        <source>reached</source>
        <translation>atteinte</translation>
    </message>
    <message numerus="yes">
        <source>%n angle(s) at a limit</source>
        <translation>
            <numerusform>%n angle à une limite</numerusform>
            <numerusform>%n angles à une limite</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message numerus="yes">
        <source>residual %1 after %n step(s)</source>
        <translation>
            <numerusform>résidu %1 après %n pas</numerusform>
            <numerusform>résidu %1 après %n pas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BranchNames</name>
    <message>
        <source>Trunk</source>
        <translation>Tronc</translation>
    </message>
    <message>
        <source>Trunk %1</source>
        <translation>Tronc %1</translation>
    </message>
    <message>
        <source>Limb %1 of the trunk, %2 m up</source>
        <translation>Branche maîtresse %1 du tronc, à %2 m</translation>
    </message>
    <message>
        <source>Limb %1 of trunk %2, %3 m up</source>
        <translation>Branche maîtresse %1 du tronc %2, à %3 m</translation>
    </message>
    <message>
        <source>Bough %1 of limb %2, %3 m along</source>
        <translation>Branche secondaire %1 de la maîtresse %2, à %3 m</translation>
    </message>
    <message>
        <source>Twig %1 of bough %2, %3 m along</source>
        <translation>Rameau %1 de la branche secondaire %2, à %3 m</translation>
    </message>
    <message>
        <source>Twig %1 of twig %2, %3 m along</source>
        <translation>Rameau %1 du rameau %2, à %3 m</translation>
    </message>
    <message>
        <source>%1, branch %2 of %3</source>
        <translation>%1, tronçon %2 sur %3</translation>
    </message>
    <message>
        <source>Branch %1 of %2</source>
        <translation>Tronçon %1 sur %2</translation>
    </message>
</context>
<context>
    <name>DialogChooser</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Enregistrer les modifications de «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>They are lost if you do not save them.</source>
        <translation>Elles seront perdues si vous ne les enregistrez pas.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>DocumentCommand</name>
    <message numerus="yes">
        <source>Roll %n branch(es)</source>
        <translation>
            <numerusform>Tourner %n branche</numerusform>
            <numerusform>Tourner %n branches</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Déverrouiller</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>New tree</source>
        <translation>Nouvel arbre</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n node(s)</source>
        <translation>
            <numerusform>Supprimer %n nœud</numerusform>
            <numerusform>Supprimer %n nœuds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n node(s)</source>
        <translation>
            <numerusform>Dupliquer %n nœud</numerusform>
            <numerusform>Dupliquer %n nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Change Timeline</source>
        <translation>Modifier la ligne de temps</translation>
    </message>
    <message>
        <source>Insert Keys</source>
        <translation>Insérer des clés</translation>
    </message>
    <message>
        <source>Add a joint</source>
        <translation>Ajouter une articulation</translation>
    </message>
    <message>
        <source>Remove joint %1</source>
        <translation>Retirer l&apos;articulation %1</translation>
    </message>
    <message>
        <source>Wear &quot;%1&quot;</source>
        <translation>Porter « %1 »</translation>
    </message>
    <message>
        <source>Fit the worn mesh again</source>
        <translation>Réajuster le maillage porté</translation>
    </message>
    <message>
        <source>Keep Bookmark %1</source>
        <translation>Garder le signet %1</translation>
    </message>
    <message>
        <source>Forget Bookmark %1</source>
        <translation>Oublier le signet %1</translation>
    </message>
    <message>
        <source>Pack pictures</source>
        <translation>Emballer les images</translation>
    </message>
    <message numerus="yes">
        <source>Shape %n limb(s)</source>
        <translation>
            <numerusform>Façonner %n branche</numerusform>
            <numerusform>Façonner %n branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n edit(s) of the tree</source>
        <translation>
            <numerusform>Supprimer %n modification de l’arbre</numerusform>
            <numerusform>Supprimer %n modifications de l’arbre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Switch %n edit(s) on</source>
        <translation>
            <numerusform>Activer %n modification</numerusform>
            <numerusform>Activer %n modifications</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Switch %n edit(s) off</source>
        <translation>
            <numerusform>Désactiver %n modification</numerusform>
            <numerusform>Désactiver %n modifications</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename edit</source>
        <translation>Renommer une modification</translation>
    </message>
    <message>
        <source>Move edit</source>
        <translation>Déplacer une modification</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n edit(s) of the tree</source>
        <translation>
            <numerusform>Copier %n modification de l’arbre</numerusform>
            <numerusform>Copier %n modifications de l’arbre</numerusform>
        </translation>
    </message>
    <message>
        <source>on</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>off</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Change %1 to %2</source>
        <comment>a parameter, its value</comment>
        <translation>Modifier %1 : %2</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <comment>a parameter, a step</comment>
        <translation>Changer %1 de %2</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n step(s)</source>
        <translation>
            <numerusform>Dupliquer %n étape</numerusform>
            <numerusform>Dupliquer %n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>Freeze the steps above</source>
        <translation>Geler les étapes du dessus</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Semis</translation>
    </message>
    <message>
        <source>Make it a tree of its own</source>
        <translation>En faire un arbre à part entière</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
</context>
<context>
    <name>ExportUses</name>
    <message>
        <source>For Blender</source>
        <translation>Pour Blender</translation>
    </message>
    <message>
        <source>For Blender and other modelling programs: every format of meshes, models and axes</source>
        <translation>Pour Blender et d’autres modeleurs : tous les formats de maillages, modèles et axes</translation>
    </message>
    <message>
        <source>For a game</source>
        <translation>Pour un jeu</translation>
    </message>
    <message>
        <source>Levels of detail by budgets of triangles, a skin, a loop of wind</source>
        <translation>Niveaux de détail par budgets de triangles, peau, boucle de vent</translation>
    </message>
    <message>
        <source>For print</source>
        <translation>Impression 3D</translation>
    </message>
    <message>
        <source>For a 3D printer: one closed surface, thick enough, in millimetres</source>
        <translation>Pour une imprimante 3D : une seule surface fermée, assez épaisse, en millimètres</translation>
    </message>
    <message>
        <source>For the web</source>
        <translation>Pour le web</translation>
    </message>
    <message>
        <source>One small file with its pictures, which can move without end</source>
        <translation>Un seul petit fichier avec ses images, qui peut bouger sans fin</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>PNG pictures of the view: one, a sequence, or from all sides; or a film</source>
        <translation>Images PNG de la vue : une seule, une suite, ou de tous les côtés ; ou un film</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>The mesh of “%1” is closed. %2: that matters for a print alone.</source>
        <translation>Le maillage de «&#xa0;%1&#xa0;» est fermé. %2&#xa0;: cela ne compte que pour une impression.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln defect(s)</source>
        <translation>
            <numerusform>%Ln défaut</numerusform>
            <numerusform>%Ln défauts</numerusform>
        </translation>
    </message>
    <message>
        <source>not closed and outward</source>
        <translation>pas fermé et tourné vers l’extérieur</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of branches collide</source>
        <translation>
            <numerusform>%Ln paire de branches se heurte</numerusform>
            <numerusform>%Ln paires de branches se heurtent</numerusform>
        </translation>
    </message>
    <message>
        <source>The mesh of “%1” is broken: %2.</source>
        <translation>Le maillage de «&#xa0;%1&#xa0;» est défectueux&#xa0;: %2.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of triangles run through each other</source>
        <translation>
            <numerusform>%Ln paire de triangles se traverse</numerusform>
            <numerusform>%Ln paires de triangles se traversent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The meshes of %Ln tree(s) are broken: %1.</source>
        <translation>
            <numerusform>Le maillage de %Ln arbre est défectueux&#xa0;: %1.</numerusform>
            <numerusform>Les maillages de %Ln arbres sont défectueux&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The meshes of %Ln tree(s) are closed. %1: that matters for a print alone.</source>
        <translation>
            <numerusform>Le maillage de %Ln arbre est fermé. %1&#xa0;: cela ne compte que pour une impression.</numerusform>
            <numerusform>Les maillages de %Ln arbres sont fermés. %1&#xa0;: cela ne compte que pour une impression.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>GestureKeys</name>
    <message>
        <source>While nodes are moved, turned or scaled</source>
        <translation>Pendant un déplacement, une rotation ou une mise à l’échelle</translation>
    </message>
    <message>
        <source>Along or about one axis; once more: of the other space; a third time: free</source>
        <translation>Le long ou autour d’un axe ; encore une fois : celui de l’autre repère ; une troisième fois : libre</translation>
    </message>
    <message>
        <source>In the plane across the axis</source>
        <translation>Dans le plan perpendiculaire à l’axe</translation>
    </message>
    <message>
        <source>Type metres, degrees (or radians) or the factor</source>
        <translation>Taper des mètres, des degrés (ou radians) ou le facteur</translation>
    </message>
    <message>
        <source>The number of the next axis</source>
        <translation>Le nombre de l’axe suivant</translation>
    </message>
    <message>
        <source>Take back a digit; without digits the mouse counts again</source>
        <translation>Reprendre un chiffre ; sans chiffres la souris compte de nouveau</translation>
    </message>
    <message>
        <source>In steps, or free of them where steps are on</source>
        <translation>Par pas, ou sans pas là où ils sont activés</translation>
    </message>
    <message>
        <source>A tenth as fast</source>
        <translation>Dix fois plus lentement</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>left click</source>
        <translation>clic gauche</translation>
    </message>
    <message>
        <source>Back to where they were</source>
        <translation>Revenir à l’état de départ</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clic droit</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>Dans la vue 3D</translation>
    </message>
    <message>
        <source>Bend a limb, or set the target of an arm</source>
        <translation>Plier une branche maîtresse, ou poser la cible d’un bras</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>glisser</translation>
    </message>
    <message>
        <source>Turn around the target</source>
        <translation>Tourner autour de la cible</translation>
    </message>
    <message>
        <source>Add to the selection, or take away</source>
        <translation>Ajouter à la sélection, ou retirer</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>While the dope sheet has the focus</source>
        <translation>Quand la feuille de clés a le focus</translation>
    </message>
    <message>
        <source>The key before or behind; with Shift it is added</source>
        <translation>La clé d’avant ou d’après ; avec Maj elle s’ajoute</translation>
    </message>
    <message>
        <source>Move the selected keys by a frame; with Shift by ten</source>
        <translation>Déplacer les clés sélectionnées d’une image ; avec Maj de dix</translation>
    </message>
    <message>
        <source>The row above or below</source>
        <translation>La ligne du dessus ou du dessous</translation>
    </message>
    <message>
        <source>Select all keys</source>
        <translation>Sélectionner toutes les clés</translation>
    </message>
    <message>
        <source>Select the column of the playhead</source>
        <translation>Sélectionner la colonne de la tête de lecture</translation>
    </message>
    <message>
        <source>Select all before or behind the playhead</source>
        <translation>Sélectionner tout avant ou après la tête de lecture</translation>
    </message>
    <message>
        <source>Cut, copy, paste at the playhead</source>
        <translation>Couper, copier, coller à la tête de lecture</translation>
    </message>
    <message>
        <source>Paste at the copied times</source>
        <translation>Coller aux moments copiés</translation>
    </message>
    <message>
        <source>Duplicate, mirror about the playhead</source>
        <translation>Dupliquer, inverser autour de la tête de lecture</translation>
    </message>
    <message>
        <source>Delete the selected keys</source>
        <translation>Supprimer les clés sélectionnées</translation>
    </message>
    <message>
        <source>Zoom in time</source>
        <translation>Zoomer dans le temps</translation>
    </message>
    <message>
        <source>Show the selected keys, or all</source>
        <translation>Montrer les clés sélectionnées, ou toutes</translation>
    </message>
    <message>
        <source>Give up the drag, or select no key</source>
        <translation>Abandonner le glissement, ou ne sélectionner aucune clé</translation>
    </message>
    <message>
        <source>Move copies of the keys</source>
        <translation>Déplacer des copies des clés</translation>
    </message>
    <message>
        <source>Between frames, without snapping</source>
        <translation>Entre les images, sans magnétisme</translation>
    </message>
    <message>
        <source>While the curve editor has the focus</source>
        <translation>Quand l’éditeur de courbes a le focus</translation>
    </message>
    <message>
        <source>Move their values by a pixel; with Shift by ten</source>
        <translation>Déplacer leurs valeurs d’un pixel ; avec Maj de dix</translation>
    </message>
    <message>
        <source>Copy, paste at the playhead</source>
        <translation>Copier, coller à la tête de lecture</translation>
    </message>
    <message>
        <source>Change values only</source>
        <translation>Ne changer que les valeurs</translation>
    </message>
    <message>
        <source>Bend a limb with the trunk and the root</source>
        <translation>Plier une branche maîtresse avec le tronc et la racine</translation>
    </message>
    <message>
        <source>Menu of the object under the cursor</source>
        <translation>Menu de l’objet sous le curseur</translation>
    </message>
    <message>
        <source>While a tree is shaped by hand</source>
        <translation>Pendant qu’un arbre est façonné à la main</translation>
    </message>
    <message>
        <source>Copy another limb, with the graft tool</source>
        <translation>Copier une autre branche, avec la greffe</translation>
    </message>
    <message>
        <source>Back to how it was; without a gesture: lay the tool down</source>
        <translation>Comme c’était ; sans geste : poser l’outil</translation>
    </message>
    <message>
        <source>In the list of edits: earlier or later</source>
        <translation>Dans la liste des retouches : plus tôt ou plus tard</translation>
    </message>
    <message>
        <source>Factor or angle of the current gesture</source>
        <translation>Facteur ou angle du geste en cours</translation>
    </message>
    <message>
        <source>The same in steps</source>
        <translation>Le même par pas</translation>
    </message>
</context>
<context>
    <name>GizmoDrag</name>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>local</source>
        <translation>local</translation>
    </message>
    <message>
        <source>parent</source>
        <translation>parent</translation>
    </message>
    <message>
        <source>world</source>
        <translation>monde</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
</context>
<context>
    <name>HandOptions</name>
    <message>
        <source>Up to</source>
        <translation>Jusqu’à</translation>
    </message>
    <message>
        <source>The saw cuts branches up to this radius</source>
        <translation>La scie coupe les branches jusqu’à ce rayon</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Radius at the foot of the new branch. 0 chooses one that suits its length and the branch it grows on</source>
        <translation>Rayon au pied de la nouvelle branche. 0 en choisit un qui convient à sa longueur et à la branche porteuse</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Bout</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>How much of the hand’s trembling is removed</source>
        <translation>Quelle part du tremblement de la main est ôtée</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Size of the copy relative to the original</source>
        <translation>Taille de la copie par rapport à l’original</translation>
    </message>
    <message>
        <source>Around the trunk</source>
        <translation>Autour du tronc</translation>
    </message>
    <message>
        <source>How many grow at once, at equal angles around the branch that carries them</source>
        <translation>Combien poussent à la fois, à angles égaux autour de la branche qui les porte</translation>
    </message>
    <message>
        <source>With all that grows on it</source>
        <translation>Avec tout ce qui pousse dessus</translation>
    </message>
    <message>
        <source>If off, only the limb itself changes</source>
        <translation>Sans cela, seule la branche elle-même change</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>En miroir</translation>
    </message>
    <message>
        <source>A second branch grows on the opposite side</source>
        <translation>Une seconde branche pousse du côté opposé</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Everything outside this shape is cut</source>
        <translation>Tout ce qui dépasse de cette forme est coupé</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>The limb curls above this share of its length and stays as it is below</source>
        <translation>La branche s’enroule au-delà de cette part de sa longueur et reste telle quelle en dessous</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cône</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Régulière</translation>
    </message>
    <message>
        <source>By pressure</source>
        <translation>Par la pression</translation>
    </message>
    <message>
        <source>By speed</source>
        <translation>Par la vitesse</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Source of the thickness along the stroke: harder pressure or a slower stroke makes it thicker</source>
        <translation>Source de l’épaisseur le long du trait : il épaissit quand le stylet appuie plus ou que la main ralentit</translation>
    </message>
    <message>
        <source>Radius at the tip relative to the radius at the beginning of the stroke</source>
        <translation>Rayon au bout par rapport au rayon au début du trait</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Cut by</source>
        <translation>Couper par</translation>
    </message>
    <message>
        <source>Cuts along a line, or everything that enters a rectangle or a lasso</source>
        <translation>Coupe le long d’une ligne, ou tout ce qui entre dans un rectangle ou un lasso</translation>
    </message>
    <message>
        <source>Attract</source>
        <translation>Attirer</translation>
    </message>
    <message>
        <source>Repel</source>
        <translation>Repousser</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peigner</translation>
    </message>
    <message>
        <source>Leaves off</source>
        <translation>Feuilles ôtées</translation>
    </message>
    <message>
        <source>Leaves on</source>
        <translation>Feuilles remises</translation>
    </message>
    <message>
        <source>Effect of the brush on branches within its radius</source>
        <translation>Effet du pinceau sur les branches dans son rayon</translation>
    </message>
    <message>
        <source>Radius of the brush; Shift and the wheel change it too. 0 chooses one that suits the tree</source>
        <translation>Rayon du pinceau ; Maj et la molette le changent aussi. 0 en choisit un qui convient à l’arbre</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>How far branches turn; the two brushes for leaves ignore it</source>
        <translation>De combien les branches tournent ; les deux pinceaux à feuilles n’en tiennent pas compte</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Drawn outline</source>
        <translation>Contour dessiné</translation>
    </message>
    <message>
        <source>Solid of the scene</source>
        <translation>Solide de la scène</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>Fruit</source>
        <translation>Fruit</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Fleur</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Adds a leaf, or a fruit or flower of the kind that the tree bears</source>
        <translation>Pose une feuille, ou un fruit ou une fleur de la sorte que porte l’arbre</translation>
    </message>
    <message>
        <source>Size relative to the leaves, fruit or flowers that grow by themselves</source>
        <translation>Taille par rapport aux feuilles, fruits ou fleurs qui poussent tout seuls</translation>
    </message>
    <message>
        <source>The limbs at this many places around the trunk, at equal angles, change too if they are similar</source>
        <translation>Les branches d’autant d’endroits autour du tronc, à angles égaux, changent aussi si elles sont semblables</translation>
    </message>
    <message>
        <source>The limb on the other side of the trunk, as the view shows it, changes too if it is similar</source>
        <translation>La branche de l’autre côté du tronc, comme la vue le montre, change aussi si elle est semblable</translation>
    </message>
    <message>
        <source>Goes</source>
        <translation>S’en va</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Tombe</translation>
    </message>
    <message>
        <source>What is cut off</source>
        <translation>Ce qui est coupé</translation>
    </message>
    <message>
        <source>It disappears at once, or it stays in place and falls to the ground when the timeline plays</source>
        <translation>Disparaît aussitôt, ou reste à sa place et tombe au sol quand la ligne de temps joue</translation>
    </message>
    <message>
        <source>Delay before falling</source>
        <translation>Délai avant la chute</translation>
    </message>
    <message>
        <source>Time on the timeline before the part comes off</source>
        <translation>Temps de la ligne de temps avant que la partie ne se détache</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>Influence</translation>
    </message>
    <message>
        <source>The length that bends below the mouse, which may extend into the branch that carries the limb. The wheel changes it while you drag. 0 bends the limb down to its foot</source>
        <translation>La longueur qui plie sous la souris, au besoin jusque dans la branche porteuse. La molette la change pendant le glissement. 0 plie la branche jusqu’à son pied</translation>
    </message>
    <message>
        <source>the limb</source>
        <translation>la branche</translation>
    </message>
    <message>
        <source>to suit</source>
        <translation>au mieux</translation>
    </message>
    <message>
        <source>Limbs up to order</source>
        <translation>Branches jusqu’à l’ordre</translation>
    </message>
    <message>
        <source>If above 0, a click on a twig selects the limb of this order that carries it: 1 for limbs of the trunk, 2 for the limbs on those, and so on. 0 selects the branch under the mouse. Shift with the wheel changes the number, too</source>
        <translation>Au-dessus de 0, un clic sur un rameau sélectionne la branche de cet ordre qui le porte : 1 pour les branches du tronc, 2 pour celles qu’elles portent, et ainsi de suite. 0 sélectionne la branche sous la souris. Maj avec la molette change aussi le nombre</translation>
    </message>
    <message>
        <source>any</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>Twigs and leaves</source>
        <translation>Rameaux et feuilles</translation>
    </message>
    <message>
        <source>Twigs with their leaves grow on the branch, as dense as on the limbs beside it</source>
        <translation>Des rameaux avec leurs feuilles poussent sur la branche, aussi serrés que sur les branches voisines</translation>
    </message>
</context>
<context>
    <name>KeyButton</name>
    <message>
        <source>%1 has a key at this frame: a click removes it, another value replaces it</source>
        <translation>%1 a une clé à cette image&#xa0;: un clic la retire, une autre valeur la remplace</translation>
    </message>
    <message>
        <source>%1 has keys at other frames: a click sets one at this frame, and so does another value</source>
        <translation>%1 a des clés à d’autres images&#xa0;: un clic en pose une à cette image, une autre valeur aussi</translation>
    </message>
    <message>
        <source>%1 has no keys: a click sets the first one, at this frame</source>
        <translation>%1 n’a pas de clé&#xa0;: un clic pose la première, à cette image</translation>
    </message>
    <message>
        <source>The key of “%1” at frame %2 is gone: Undo brings it back.</source>
        <translation>La clé de «&#xa0;%1&#xa0;» à l’image %2 est retirée&#xa0;: Annuler la ramène.</translation>
    </message>
    <message>
        <source>“%1” has a key at frame %2 now: Undo takes it back.</source>
        <translation>«&#xa0;%1&#xa0;» a maintenant une clé à l’image %2&#xa0;: Annuler la retire.</translation>
    </message>
</context>
<context>
    <name>KindTexts</name>
    <message>
        <source>Boundary edges</source>
        <translation>Arêtes de bord</translation>
    </message>
    <message>
        <source>An edge with a face on one side only: the surface is open there, like the rim of a cup.</source>
        <translation>Une arête avec une face d’un seul côté&#xa0;: la surface y est ouverte, comme le bord d’une tasse.</translation>
    </message>
    <message>
        <source>A slicer cannot tell inside from outside. It leaves the hole open or fills it as it likes.</source>
        <translation>Un trancheur ne distingue plus l’intérieur de l’extérieur. Il laisse le trou ouvert ou le comble à sa guise.</translation>
    </message>
    <message>
        <source>One looks into the branch through the hole, and light and shadow leak through it.</source>
        <translation>On voit dans la branche par le trou&#xa0;; lumière et ombre y fuient.</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Arêtes non-variété</translation>
    </message>
    <message>
        <source>Three faces or more meet in one edge, like the pages of a book in its spine.</source>
        <translation>Trois faces ou plus se rejoignent en une arête, comme les pages d’un livre à sa reliure.</translation>
    </message>
    <message>
        <source>No solid body has such an edge: walls go missing or come out twice.</source>
        <translation>Aucun corps solide n’a une telle arête&#xa0;: des parois manquent ou sortent en double.</translation>
    </message>
    <message>
        <source>Smoothing, subdividing and unwrapping go wrong around it; the shading shows a seam.</source>
        <translation>Lissage, subdivision et dépliage échouent autour d’elle&#xa0;; l’éclairage montre une couture.</translation>
    </message>
    <message>
        <source>Inconsistent edges</source>
        <translation>Arêtes incohérentes</translation>
    </message>
    <message>
        <source>Two neighbouring faces do not agree on which side is outside.</source>
        <translation>Deux faces voisines ne s’accordent pas sur le côté extérieur.</translation>
    </message>
    <message>
        <source>Inside and outside change places: parts come out hollow or missing.</source>
        <translation>Intérieur et extérieur s’échangent&#xa0;: des parties sortent creuses ou manquent.</translation>
    </message>
    <message>
        <source>One of the two faces shows its back. Programs that do not draw back faces show a hole there, others light it from the wrong side.</source>
        <translation>L’une des deux faces montre son dos. Les programmes qui ne dessinent pas les faces arrière y montrent un trou, les autres l’éclairent du mauvais côté.</translation>
    </message>
    <message>
        <source>Non-manifold vertices</source>
        <translation>Sommets non-variété</translation>
    </message>
    <message>
        <source>Two parts of the surface touch in a single point, like the halves of an hourglass.</source>
        <translation>Deux parties de la surface se touchent en un seul point, comme les moitiés d’un sablier.</translation>
    </message>
    <message>
        <source>A joint without thickness: it breaks, or the parts come out separate.</source>
        <translation>Une jointure sans épaisseur&#xa0;: elle casse, ou les parties sortent séparées.</translation>
    </message>
    <message>
        <source>Smooth normals mix both parts and leave a dark spot; physics and level-of-detail tools may refuse the mesh.</source>
        <translation>Les normales lissées mélangent les deux parties et laissent une tache sombre&#xa0;; les outils de physique ou de niveau de détail peuvent refuser le maillage.</translation>
    </message>
    <message>
        <source>Duplicate vertices</source>
        <translation>Sommets en double</translation>
    </message>
    <message>
        <source>Two vertices stand at exactly the same place.</source>
        <translation>Deux sommets sont exactement au même endroit.</translation>
    </message>
    <message>
        <source>The surface looks closed and yet is slit there; programs that weld points may close it wrongly.</source>
        <translation>La surface paraît fermée mais y est fendue&#xa0;; les programmes qui soudent les points peuvent la refermer de travers.</translation>
    </message>
    <message>
        <source>The shading may show a seam, and the surface tears open when it moves.</source>
        <translation>L’éclairage peut montrer une couture, et la surface se déchire quand elle bouge.</translation>
    </message>
    <message>
        <source>Isolated vertices</source>
        <translation>Sommets isolés</translation>
    </message>
    <message>
        <source>A vertex that no face uses.</source>
        <translation>Un sommet qu’aucune face n’utilise.</translation>
    </message>
    <message>
        <source>Nothing is printed there, but some programs refuse the file.</source>
        <translation>Rien n’y est imprimé, mais certains programmes refusent le fichier.</translation>
    </message>
    <message>
        <source>It takes memory and may enlarge the box around the tree, so that the view frames it badly.</source>
        <translation>Il prend de la mémoire et peut agrandir la boîte autour de l’arbre, si bien que la vue le cadre mal.</translation>
    </message>
    <message>
        <source>Duplicate faces</source>
        <translation>Faces en double</translation>
    </message>
    <message>
        <source>Two faces on the same three vertices.</source>
        <translation>Deux faces sur les mêmes trois sommets.</translation>
    </message>
    <message>
        <source>A wall without thickness. Slicers drop both faces, or only one and leave a hole.</source>
        <translation>Une paroi sans épaisseur. Les trancheurs retirent les deux faces, ou une seule et laissent un trou.</translation>
    </message>
    <message>
        <source>Both lie at the same depth and flicker.</source>
        <translation>Les deux sont à la même profondeur et scintillent.</translation>
    </message>
    <message>
        <source>Degenerate faces</source>
        <translation>Faces dégénérées</translation>
    </message>
    <message>
        <source>A face without area: a vertex repeated, or its three vertices in line.</source>
        <translation>Une face sans aire&#xa0;: un sommet répété, ou ses trois sommets alignés.</translation>
    </message>
    <message>
        <source>It faces nowhere. Slicers remove it, which may leave a crack.</source>
        <translation>Elle ne regarde nulle part. Les trancheurs la retirent, ce qui peut laisser une fissure.</translation>
    </message>
    <message>
        <source>It cannot be seen, costs time and has no normal: dark specks, and normal maps fail.</source>
        <translation>Elle est invisible, coûte du temps et n’a pas de normale&#xa0;: points sombres, et les cartes de normales échouent.</translation>
    </message>
    <message>
        <source>Roots without length</source>
        <translation>Racines sans longueur</translation>
    </message>
    <message>
        <source>A root without length was given a short stub, so that the branches have something to stand on.</source>
        <translation>Une racine sans longueur a reçu un court moignon, pour que les branches aient où se tenir.</translation>
    </message>
    <message>
        <source>Siblings in one place</source>
        <translation>Sœurs au même endroit</translation>
    </message>
    <message>
        <source>Two branches of one parent lie in the same place, so one tube serves both. Two tubes there would cross each other all along.</source>
        <translation>Deux branches d’un même parent sont au même endroit&#xa0;: un seul tube sert aux deux. Deux tubes s’y croiseraient tout du long.</translation>
    </message>
    <message>
        <source>Siblings inside a longer one</source>
        <translation>Sœurs dans une plus longue</translation>
    </message>
    <message>
        <source>Radii too small</source>
        <translation>Rayons trop petits</translation>
    </message>
    <message>
        <source>What this means</source>
        <translation>Ce que cela veut dire</translation>
    </message>
    <message>
        <source>The mesh is a solid body; a slicer takes it as it is.</source>
        <translation>Le maillage est un corps solide&#xa0;; un trancheur le prend tel quel.</translation>
    </message>
    <message>
        <source>Smooth shading, subdividing, unwrapping and physics work without repair.</source>
        <translation>Lissage, subdivision, dépliage et physique marchent sans réparation.</translation>
    </message>
    <message>
        <source>In a print:</source>
        <translation>À l’impression&#xa0;:</translation>
    </message>
    <message>
        <source>In a game or a renderer:</source>
        <translation>Dans un jeu ou un moteur de rendu&#xa0;:</translation>
    </message>
    <message>
        <source>Crossings within a branch</source>
        <translation>Croisements dans une branche</translation>
    </message>
    <message>
        <source>Triangles of one branch run through each other: its surface folds over where it bends sharply or begins at a tight fork.</source>
        <translation>Des triangles d’une même branche se traversent : sa surface se replie là où elle se courbe fortement ou naît d’une fourche serrée.</translation>
    </message>
    <message>
        <source>A fold of a hair&apos;s breadth inside the wood: slicers that add up walls do not notice it.</source>
        <translation>Un pli de l’épaisseur d’un cheveu à l’intérieur du bois : les trancheurs qui réunissent les parois ne le remarquent pas.</translation>
    </message>
    <message>
        <source>A small crease in the shading, and a false edge for tools that cut the mesh.</source>
        <translation>Un petit pli dans l’ombrage, et une fausse arête pour les outils qui découpent le maillage.</translation>
    </message>
    <message>
        <source>Crossings between siblings</source>
        <translation>Croisements entre sœurs</translation>
    </message>
    <message>
        <source>Two branches that start at one fork run through each other behind it: they stay close for longer than they are thick.</source>
        <translation>Deux branches nées de la même fourche se traversent au-delà : elles restent proches sur une longueur plus grande que leur épaisseur.</translation>
    </message>
    <message>
        <source>Both are one body there. Most slicers join them; some leave a hollow where they overlap.</source>
        <translation>Elles n’y font qu’un seul corps. La plupart des trancheurs les réunissent ; certains laissent un creux là où elles se recouvrent.</translation>
    </message>
    <message>
        <source>The crease between them is hard, not a valley; leaves and bark may flicker in it.</source>
        <translation>Le pli entre elles est net, ce n’est pas un creux arrondi ; feuilles et écorce peuvent y scintiller.</translation>
    </message>
    <message>
        <source>Crossings of parent and child</source>
        <translation>Croisements entre parent et enfant</translation>
    </message>
    <message>
        <source>A branch runs back into the one that it grows on: it turns by more than a right angle.</source>
        <translation>Une branche rentre dans celle qui la porte : elle tourne de plus d’un angle droit.</translation>
    </message>
    <message>
        <source>The overlap lies inside the wood. Most slicers join the two.</source>
        <translation>Le recouvrement est à l’intérieur du bois. La plupart des trancheurs réunissent les deux.</translation>
    </message>
    <message>
        <source>The bark of one comes out of the other without a seam between them.</source>
        <translation>L’écorce de l’une sort de l’autre, sans couture entre elles.</translation>
    </message>
    <message>
        <source>Crossings far apart</source>
        <translation>Croisements éloignés</translation>
    </message>
    <message>
        <source>Triangles of branches run through each other that do not meet in any fork.</source>
        <translation>Des triangles se traversent dont les branches ne se rejoignent dans aucune fourche.</translation>
    </message>
    <message>
        <source>The branches are one body where they cross.</source>
        <translation>Les branches ne font qu’un seul corps là où elles se croisent.</translation>
    </message>
    <message>
        <source>They go through each other, and do so when the wind moves them.</source>
        <translation>Elles se traversent, aussi quand le vent les remue.</translation>
    </message>
    <message>
        <source>Branches that collide</source>
        <translation>Branches qui se heurtent</translation>
    </message>
    <message>
        <source>Two branches far from each other in the tree run through each other. The mesh is correct: the tree grew so. “Move apart” turns the thinner branch away, as little as possible.</source>
        <translation>Deux branches éloignées dans l’arbre se traversent. Le maillage est correct : l’arbre a poussé ainsi. « Écarter » tourne la plus mince, aussi peu que possible.</translation>
    </message>
    <message>
        <source>They come out as one body, joined where they cross. Slicers that do not join overlapping walls leave a hollow there.</source>
        <translation>Elles sortent en un seul corps, soudées là où elles se croisent. Les trancheurs qui ne réunissent pas les parois y laissent un creux.</translation>
    </message>
    <message>
        <source>Up close one sees a branch go through another; in the wind both move through each other.</source>
        <translation>De près, on voit une branche en traverser une autre ; au vent, elles bougent l’une à travers l’autre.</translation>
    </message>
    <message>
        <source>Thinnest triangles</source>
        <translation>Triangles les plus minces</translation>
    </message>
    <message>
        <source>The triangles with the smallest angles. They are no defects: every mesh has some.</source>
        <translation>Les triangles aux plus petits angles. Ce ne sont pas des défauts : tout maillage en a.</translation>
    </message>
    <message>
        <source>They do no harm as long as they have an area.</source>
        <translation>Elles ne gênent pas tant qu’elles ont une aire.</translation>
    </message>
    <message>
        <source>Long thin triangles shade in streaks, subdivide badly and slow down computations on the surface.</source>
        <translation>Les longs triangles minces donnent des stries d’ombrage, se subdivisent mal et ralentissent les calculs sur la surface.</translation>
    </message>
    <message>
        <source>A terrain or a plane has an edge by its nature, so its surface is open there. Nothing else is wrong with it: no other holes or seams, and all faces look to the same side.</source>
        <translation>Un terrain ou un plan a un bord par nature&#xa0;: sa surface y est ouverte. Rien d’autre ne lui manque&#xa0;: ni autres trous ni coutures, et toutes les faces regardent du même côté.</translation>
    </message>
    <message>
        <source>It encloses nothing. Give it a thickness before it goes to a slicer.</source>
        <translation>Elle n’enferme rien. Donnez-lui une épaisseur avant de la confier à un trancheur.</translation>
    </message>
    <message>
        <source>Smooth shading, subdividing and physics work; from below one sees its back.</source>
        <translation>L’ombrage lisse, la subdivision et la physique fonctionnent&#xa0;; d’en bas on voit son revers.</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Croisements</translation>
    </message>
    <message>
        <source>Triangles of the mesh run through each other.</source>
        <translation>Des triangles du maillage se traversent.</translation>
    </message>
    <message>
        <source>Most slicers join overlapping parts; some leave a hollow there.</source>
        <translation>La plupart des trancheurs réunissent les parties qui se recouvrent ; certains y laissent un creux.</translation>
    </message>
    <message>
        <source>A hard crease where they meet, and false edges for tools that cut the mesh.</source>
        <translation>Un pli dur là où ils se rencontrent, et de fausses arêtes pour les outils qui coupent le maillage.</translation>
    </message>
    <message>
        <source>The branches are one closed skin without holes or seams: every edge has exactly two faces, and all faces look outward. No triangle runs through another.</source>
        <translation>Les branches forment une seule peau fermée, sans trou ni couture : chaque arête a exactement deux faces, et toutes les faces regardent vers l’extérieur. Aucun triangle n’en traverse un autre.</translation>
    </message>
    <message>
        <source>The surface has no holes or seams, but parts of it run through each other. Each such place is listed above.</source>
        <translation>La surface n’a ni trou ni couture, mais des parties se traversent. Chaque endroit figure dans la liste ci-dessus.</translation>
    </message>
    <message>
        <source>The surface is closed, without holes or seams: every edge has exactly two faces, and all faces look outward. No triangle runs through another.</source>
        <translation>La surface est fermée, sans trou ni couture : chaque arête a exactement deux faces, et toutes les faces regardent vers l’extérieur. Aucun triangle n’en traverse un autre.</translation>
    </message>
    <message>
        <source>Stems from one place</source>
        <translation>Troncs partant d’un même lieu</translation>
    </message>
    <message>
        <source>Stems that start within a radius of each other stand on one plate at the ground, so that they are one mesh. Two meshes there would run through each other.</source>
        <translation>Des troncs qui partent à moins d’un rayon les uns des autres reposent sur un même plateau au sol, de sorte qu’ils ne font qu’un maillage. Deux maillages s’y traverseraient.</translation>
    </message>
    <message>
        <source>Branches that do not show</source>
        <translation>Branches qu&apos;on ne voit pas</translation>
    </message>
    <message>
        <source>A branch without length, or with all of it inside a thicker one, was passed over: its children start at its parent&apos;s end. Nothing that could be seen is lost.</source>
        <translation>Une branche sans longueur, ou tout entière dans une plus épaisse, a été passée : ses enfants partent de la fin de son parent. Rien de visible n&apos;est perdu.</translation>
    </message>
    <message>
        <source>A branch leaves one of the same parent only at its end, or beyond: it starts there.</source>
        <translation>Une branche ne quitte une autre du même parent qu&apos;à la fin de celle-ci, ou plus loin : elle part de là.</translation>
    </message>
    <message>
        <source>The radius was below the least one (Cross-sections, Least radius), or so small against the size of the tree that the tube&apos;s points would fall together. It was raised to the smallest that works; no printer makes it that thin.</source>
        <translation>Le rayon était inférieur au rayon minimal (Sections, Rayon minimal), ou si petit devant la taille de l’arbre que les points du tube se confondraient. Il a été porté au plus petit qui marche&#xa0;; aucune imprimante ne fait si fin.</translation>
    </message>
</context>
<context>
    <name>NodeEdits</name>
    <message>
        <source>Move nodes</source>
        <translation>Déplacer des nœuds</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoler</translation>
    </message>
</context>
<context>
    <name>NodeWords</name>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>le nœud</numerusform>
            <numerusform>les %n nœuds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Numbers</name>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Handbook</source>
        <translation>Manuel</translation>
    </message>
</context>
<context>
    <name>PanelHints</name>
    <message>
        <source>Drag: go to a frame · a handle: range · wheel: zoom · Shift + wheel: scroll · double click: whole range</source>
        <translation>Glisser : aller à une image · une poignée : plage · molette : zoom · Maj + molette : défiler · double clic : toute la plage</translation>
    </message>
    <message>
        <source>Click: select · drag: move · Shift: add, between frames · Ctrl + drag: copies · Alt + click: column · Ctrl + wheel: zoom</source>
        <translation>Clic : sélectionner · glisser : déplacer · Maj : ajouter, entre les images · Ctrl + glisser : copies · Alt + clic : colonne · Ctrl + molette : zoom</translation>
    </message>
    <message>
        <source>Click: select · drag: move · Shift: add, between frames · Ctrl + drag: value only · Ctrl + wheel: zoom</source>
        <translation>Clic : sélectionner · glisser : déplacer · Maj : ajouter, entre les images · Ctrl + glisser : valeur seule · Ctrl + molette : zoom</translation>
    </message>
    <message>
        <source>Drag: turn both · wheel: nearer or farther · arrow keys: turn · Home: from the front</source>
        <translation>Glisser&#xa0;: tourner les deux · molette&#xa0;: plus près ou plus loin · flèches&#xa0;: tourner · Début&#xa0;: de face</translation>
    </message>
</context>
<context>
    <name>ParamFacts</name>
    <message>
        <source>metres; also cm, mm, km, in, ft</source>
        <translation>mètres ; aussi cm, mm, km, in, ft</translation>
    </message>
    <message>
        <source>degrees; also rad, turn, pi</source>
        <translation>degrés ; aussi rad, turn, pi</translation>
    </message>
    <message>
        <source>radians; also deg, turn, pi</source>
        <translation>radians ; aussi deg, turn, pi</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>a ratio; also %</source>
        <translation>un rapport ; aussi %</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>seconds; also ms, min</source>
        <translation>secondes ; aussi ms, min</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>kilograms; also g</source>
        <translation>kilogrammes ; aussi g</translation>
    </message>
    <message>
        <source>a factor</source>
        <translation>un facteur</translation>
    </message>
    <message>
        <source>per cent</source>
        <translation>pour cent</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>Dans %1</translation>
    </message>
    <message>
        <source>about %1 m/s on average</source>
        <translation>environ %1 m/s en moyenne</translation>
    </message>
    <message>
        <source>years</source>
        <translation>années</translation>
    </message>
    <message>
        <source>days of the year: 1 is the first of January</source>
        <translation>jours de l’année : 1 est le premier janvier</translation>
    </message>
    <message>
        <source>d MMMM</source>
        <comment>a day of the year</comment>
        <translation>d MMMM</translation>
    </message>
    <message>
        <source>no day: see Season</source>
        <translation>aucun jour : voir Saison</translation>
    </message>
</context>
<context>
    <name>ParamPage</name>
    <message>
        <source>Parameters</source>
        <translation>Les paramètres</translation>
    </message>
    <message>
        <source>The key is the name in project files, and on the command line: `--set key=value`. Numbers outside the range are refused.</source>
        <translation>La clé est le nom dans les fichiers de projet et en ligne de commande : `--set clé=valeur`. Les nombres hors de la plage sont refusés.</translation>
    </message>
</context>
<context>
    <name>ReportTexts</name>
    <message numerus="yes">
        <source>%1 vertices, %2 faces, volume %3, Euler characteristic %4, %Ln piece(s)</source>
        <translation>
            <numerusform>%1 sommets, %2 faces, volume %3, caractéristique d’Euler %4, %Ln morceau</numerusform>
            <numerusform>%1 sommets, %2 faces, volume %3, caractéristique d’Euler %4, %Ln morceaux</numerusform>
        </translation>
    </message>
    <message>
        <source>Confirmed by OpenMesh.</source>
        <translation>Confirmé par OpenMesh.</translation>
    </message>
    <message>
        <source>OpenMesh refuses the mesh.</source>
        <translation>OpenMesh refuse le maillage.</translation>
    </message>
    <message>
        <source>A draft: the full mesh follows.</source>
        <translation>Une ébauche&#xa0;: le maillage complet suit.</translation>
    </message>
    <message>
        <source>OpenMesh has not been asked yet.</source>
        <translation>OpenMesh n’a pas encore été consulté.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln defect(s)</source>
        <translation>
            <numerusform>%Ln défaut</numerusform>
            <numerusform>%Ln défauts</numerusform>
        </translation>
    </message>
    <message>
        <source>The mesh has no faces</source>
        <translation>Le maillage n’a pas de faces</translation>
    </message>
    <message>
        <source>Closed, but inside out</source>
        <translation>Fermé, mais retourné</translation>
    </message>
    <message>
        <source>More or fewer pieces than roots (%1)</source>
        <translation>Plus ou moins de morceaux que de racines (%1)</translation>
    </message>
    <message>
        <source>The two checks do not agree</source>
        <translation>Les deux vérifications ne s’accordent pas</translation>
    </message>
    <message>
        <source>Not checked yet</source>
        <translation>Pas encore vérifié</translation>
    </message>
    <message>
        <source>The mesh is being made.</source>
        <translation>Le maillage est en cours de construction.</translation>
    </message>
    <message>
        <source>No mesh to check</source>
        <translation>Pas de maillage à vérifier</translation>
    </message>
    <message>
        <source>branch %1</source>
        <translation>branche %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Check of the mesh of &quot;%1&quot;</source>
        <translation>Vérification du maillage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Repairs of the mesher:</source>
        <translation>Réparations du mailleur&#xa0;:</translation>
    </message>
    <message>
        <source>No triangle runs through another.</source>
        <translation>Aucun triangle n’en traverse un autre.</translation>
    </message>
    <message>
        <source>No triangles cross at forks.</source>
        <translation>Aucun triangle ne se croise aux fourches.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of triangles cross at forks.</source>
        <translation>
            <numerusform>%Ln paire de triangles se croise aux fourches.</numerusform>
            <numerusform>%Ln paires de triangles se croisent aux fourches.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of branches collide (%1 pairs of triangles).</source>
        <translation>
            <numerusform>%Ln paire de branches se heurte (%1 paires de triangles).</numerusform>
            <numerusform>%Ln paires de branches se heurtent (%1 paires de triangles).</numerusform>
        </translation>
    </message>
    <message>
        <source>Smallest angle %1, largest aspect ratio %2</source>
        <translation>Plus petit angle %1, plus grand allongement %2</translation>
    </message>
    <message>
        <source>Hash %1</source>
        <translation>Empreinte %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 vertices, %2 faces, Euler characteristic %3, %Ln piece(s)</source>
        <translation>
            <numerusform>%1 sommets, %2 faces, caractéristique d’Euler %3, %Ln morceau</numerusform>
            <numerusform>%1 sommets, %2 faces, caractéristique d’Euler %3, %Ln morceaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Closed, but %Ln pair(s) of triangles run through each other</source>
        <translation>
            <numerusform>Fermé, mais %Ln paire de triangles se traverse</numerusform>
            <numerusform>Fermé, mais %Ln paires de triangles se traversent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Oriented, but %Ln pair(s) of triangles run through each other</source>
        <translation>
            <numerusform>Orienté, mais %Ln paire de triangles se traverse</numerusform>
            <numerusform>Orienté, mais %Ln paires de triangles se traversent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of triangles run through each other.</source>
        <translation>
            <numerusform>%Ln paire de triangles se traverse.</numerusform>
            <numerusform>%Ln paires de triangles se traversent.</numerusform>
        </translation>
    </message>
    <message>
        <source>An open surface, manifold and oriented, free of crossings</source>
        <translation>Une surface ouverte, variété orientée, sans croisement</translation>
    </message>
    <message>
        <source>Closed and free of crossings</source>
        <translation>Fermé et sans croisement</translation>
    </message>
    <message>
        <source>An open surface, manifold and oriented; crossings not looked for yet</source>
        <translation>Une surface ouverte, variété orientée&#xa0;; croisements pas encore cherchés</translation>
    </message>
    <message>
        <source>Closed; crossings not looked for yet</source>
        <translation>Fermé&#xa0;; croisements pas encore cherchés</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of vertices within %1 of each other</source>
        <translation>
            <numerusform>%Ln paire de sommets à %1 au plus l’un de l’autre</numerusform>
            <numerusform>%Ln paires de sommets à %1 au plus l’un de l’autre</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SceneQuery</name>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordre</translation>
    </message>
    <message>
        <source>children</source>
        <translation>enfants</translation>
    </message>
    <message>
        <source>terminal</source>
        <translation>terminale</translation>
    </message>
    <message>
        <source>number</source>
        <translation>numéro</translation>
    </message>
</context>
<context>
    <name>Targets</name>
    <message>
        <source>nothing in the scene has it</source>
        <translation>rien dans la scène ne l’a</translation>
    </message>
    <message>
        <source>no effect now: another value turns it off</source>
        <translation>sans effet maintenant : une autre valeur le désactive</translation>
    </message>
    <message>
        <source>no effect while “%1” is “%2”</source>
        <translation>sans effet tant que « %1 » est « %2 »</translation>
    </message>
    <message>
        <source>no effect while “%1” is off</source>
        <translation>sans effet tant que « %1 » est désactivé</translation>
    </message>
</context>
<context>
    <name>TextureLegend</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>One square: a tile, %1 on the thickest wood</source>
        <translation>Un carré : un carreau, %1 sur le bois le plus épais</translation>
    </message>
    <message>
        <source>Tiles too small to see are joined: 2, 4, 8 …</source>
        <translation>Les carreaux trop petits sont réunis : 2, 4, 8 …</translation>
    </message>
    <message>
        <source>Stretch of the texture</source>
        <translation>Étirement de la texture</translation>
    </message>
    <message>
        <source>Under 1.25: %1 % of the triangles</source>
        <translation>Sous 1,25 : %1 % des triangles</translation>
    </message>
    <message>
        <source>Mirrored: %1</source>
        <translation>Inversés : %1</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Look around</source>
        <translation>Regarder</translation>
    </message>
    <message>
        <source>Hold the middle mouse button and drag to turn the view. Drag with Shift to move it; turn the wheel to zoom. %1 shows the whole tree.</source>
        <translation>Glissez avec le bouton du milieu pour tourner la vue, avec Maj pour la déplacer ; la molette zoome. %1 montre tout l’arbre.</translation>
    </message>
    <message>
        <source>Grow another tree</source>
        <translation>Faire pousser un autre arbre</translation>
    </message>
    <message>
        <source>Press %1: the same rules grow another tree. Undo brings the first one back.</source>
        <translation>Appuyez sur %1 : les mêmes règles font pousser un autre arbre. Annuler ramène le premier.</translation>
    </message>
    <message>
        <source>Change it</source>
        <translation>Le modifier</translation>
    </message>
    <message>
        <source>Drag a number or its slider, or type a value such as 18 deg. The tree follows while you drag. F1 on a row explains it.</source>
        <translation>Glissez sur un nombre ou sur son curseur, ou tapez une valeur comme 18 deg. L’arbre suit pendant le geste. F1 sur une ligne l’explique.</translation>
    </message>
    <message>
        <source>Let it move</source>
        <translation>Le faire bouger</translation>
    </message>
    <message>
        <source>Press %1 to play: the tree moves in the wind. While it plays, drag a branch and let it go.</source>
        <translation>Appuyez sur %1 pour lancer la lecture : l’arbre bouge dans le vent. Tirez alors une branche et lâchez-la.</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>L’emporter</translation>
    </message>
    <message>
        <source>%1 writes the mesh for other programs, or pictures. Anything else: F3 finds every command, F1 opens the handbook.</source>
        <translation>%1 écrit le maillage pour d’autres programmes, ou des images. Pour tout le reste : F3 trouve chaque commande, F1 ouvre le manuel.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>A slim leaning trunk with a mop of feather fronds</source>
        <translation>Un tronc mince et penché, coiffé de palmes en plumes</translation>
    </message>
    <message>
        <source>A straight column under a fountain of stiff fronds</source>
        <translation>Une colonne droite sous une fontaine de palmes raides</translation>
    </message>
    <message>
        <source>A stout column below a head of fans</source>
        <translation>Une forte colonne sous une tête d’éventails</translation>
    </message>
    <message>
        <source>A fibrous trunk with a parasol of ferns</source>
        <translation>Un tronc fibreux et son parasol de fougères</translation>
    </message>
    <message>
        <source>Forking corky arms that end in bunches of daggers</source>
        <translation>Des bras de liège fourchus, terminés par des bouquets de poignards</translation>
    </message>
    <message>
        <source>A broken pine trunk with the stubs of its limbs</source>
        <translation>Un tronc de pin brisé, avec les moignons de ses branches</translation>
    </message>
    <message>
        <source>A young birch, three metres high</source>
        <translation>Un jeune bouleau, haut de trois mètres</translation>
    </message>
    <message>
        <source>An English oak in winter, without a leaf</source>
        <translation>Un chêne pédonculé en hiver, sans une feuille</translation>
    </message>
    <message>
        <source>Forms</source>
        <translation>Formes</translation>
    </message>
    <message>
        <source>A round dense head on a short straight trunk</source>
        <translation>Une tête ronde et dense sur un tronc court et droit</translation>
    </message>
    <message>
        <source>A tall open dome of stout rising limbs</source>
        <translation>Un haut dôme ouvert de fortes branches montantes</translation>
    </message>
    <message>
        <source>A huge ribbed trunk below a broad crown of long leaves</source>
        <translation>Un énorme tronc côtelé sous une large cime de longues feuilles</translation>
    </message>
    <message>
        <source>Far wider than high: heavy limbs that sink and rise again</source>
        <translation>Bien plus large que haut&#xa0;: de lourdes branches qui plongent et remontent</translation>
    </message>
    <message>
        <source>A wide fountain: the trunk parts low, its limbs arch over</source>
        <translation>Une large fontaine&#xa0;: le tronc se divise bas, ses branches retombent en arceaux</translation>
    </message>
    <message>
        <source>A straight tall mast with short rising limbs</source>
        <translation>Un haut mât droit aux courtes branches montantes</translation>
    </message>
    <message>
        <source>A light open crown that lets the sun through</source>
        <translation>Une cime légère et ouverte qui laisse passer le soleil</translation>
    </message>
    <message>
        <source>A loose vase of ferny leaves on crooked limbs</source>
        <translation>Un vase lâche de feuilles de fougère sur des branches tortues</translation>
    </message>
    <message>
        <source>A vast flat parasol on a short stout trunk</source>
        <translation>Un vaste parasol plat sur un tronc court et fort</translation>
    </message>
    <message>
        <source>A slim cone beside water, with round dark leaves</source>
        <translation>Un cône élancé au bord de l’eau, aux feuilles rondes et sombres</translation>
    </message>
    <message>
        <source>A fluted grey trunk in a close egg of leaves</source>
        <translation>Un tronc gris cannelé dans un œuf serré de feuilles</translation>
    </message>
    <message>
        <source>A stiff broad cone of level limbs</source>
        <translation>Un cône raide et large de branches étagées</translation>
    </message>
    <message>
        <source>A tower with a narrow crown of sinking limbs</source>
        <translation>Une tour à la cime étroite, aux branches tombantes</translation>
    </message>
    <message>
        <source>A wide cone whose limbs and top hang over</source>
        <translation>Un large cône dont les branches et la flèche retombent</translation>
    </message>
    <message>
        <source>the name of an organ is expected here: %1</source>
        <translation>un nom d’organe est attendu ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no organ &quot;%1&quot;; there are %2</source>
        <translation>il n’y a pas d’organe «&#xa0;%1&#xa0;»&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>%1 asks for a size below 0, or beyond all measure</source>
        <translation>%1 demande une taille inférieure à 0, ou démesurée</translation>
    </message>
    <message>
        <source>%1 has no branch before it that could carry it</source>
        <translation>%1 n’a avant lui aucune branche qui puisse le porter</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no branches</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas de branches</translation>
    </message>
    <message>
        <source>a roll must be a finite angle</source>
        <translation>un roulis doit être un angle fini</translation>
    </message>
    <message>
        <source>there is no node %1</source>
        <translation>il n’y a pas de nœud %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is locked</source>
        <translation>«&#xa0;%1&#xa0;» est verrouillé</translation>
    </message>
    <message>
        <source>a scale of zero leaves nothing to export</source>
        <translation>une échelle nulle ne laisse rien à exporter</translation>
    </message>
    <message>
        <source>the tree is still being computed</source>
        <translation>l’arbre est encore en cours de calcul</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>the chosen parts are empty: there is nothing to export</source>
        <translation>les parties choisies sont vides&#xa0;: il n’y a rien à exporter</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no such parameter</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas ce paramètre</translation>
    </message>
    <message>
        <source>there is no tree that could be drawn anew</source>
        <translation>il n’y a pas d’arbre à tirer de nouveau</translation>
    </message>
    <message>
        <source>the file is larger than %1 MiB</source>
        <translation>le fichier dépasse %1 Mio</translation>
    </message>
    <message>
        <source>not readable as JSON: %1</source>
        <translation>illisible comme JSON&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is no Ramure project: an object is expected</source>
        <translation>ce n’est pas un projet Ramure&#xa0;: un objet est attendu</translation>
    </message>
    <message>
        <source>an array is expected here</source>
        <translation>un tableau est attendu ici</translation>
    </message>
    <message>
        <source>an object is expected here</source>
        <translation>un objet est attendu ici</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ouverture impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>lecture impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>the project would be larger than %1 MiB</source>
        <translation>le projet dépasserait %1 Mio</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>écriture impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>a text, or an array of its lines, is expected here</source>
        <translation>un texte, ou le tableau de ses lignes, est attendu ici</translation>
    </message>
    <message>
        <source>a text is expected here</source>
        <translation>un texte est attendu ici</translation>
    </message>
    <message>
        <source>an array of three numbers is expected here</source>
        <translation>un tableau de trois nombres est attendu ici</translation>
    </message>
    <message>
        <source>a number is expected here</source>
        <translation>un nombre est attendu ici</translation>
    </message>
    <message>
        <source>a whole number is expected here</source>
        <translation>un nombre entier est attendu ici</translation>
    </message>
    <message>
        <source>true or false is expected here</source>
        <translation>true ou false est attendu ici</translation>
    </message>
    <message>
        <source>the key of a branch has 16 digits 0-9, a-f</source>
        <translation>la clé d’une branche a 16 chiffres 0-9, a-f</translation>
    </message>
    <message>
        <source>this is no Ramure project: &quot;ramure&quot; is expected here</source>
        <translation>ce n’est pas un projet Ramure&#xa0;: «&#xa0;ramure&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>a whole number from 1 is expected here</source>
        <translation>un nombre entier à partir de 1 est attendu ici</translation>
    </message>
    <message>
        <source>the file has version %1, this program reads versions up to %2; a newer Ramure is needed</source>
        <translation>le fichier est de version %1, ce programme lit jusqu’à la version %2&#xa0;; il faut un Ramure plus récent</translation>
    </message>
    <message>
        <source>a whole number from 1 to 4294967295 is expected here</source>
        <translation>un nombre entier de 1 à 4294967295 est attendu ici</translation>
    </message>
    <message>
        <source>the new parent is flat: a scale is zero</source>
        <translation>le nouveau parent est plat&#xa0;: une échelle est nulle</translation>
    </message>
    <message>
        <source>the backquote takes the next character as it is, but the line ends here</source>
        <translation>l’accent grave prend le caractère suivant tel quel, mais la ligne finit ici</translation>
    </message>
    <message>
        <source>this &quot;]&quot; has no &quot;[&quot; before it</source>
        <translation>ce «&#xa0;]&#xa0;» n’a pas de «&#xa0;[&#xa0;» avant lui</translation>
    </message>
    <message>
        <source>this &quot;[&quot; is never closed</source>
        <translation>ce «&#xa0;[&#xa0;» n’est jamais fermé</translation>
    </message>
    <message>
        <source>a probability must be a finite number</source>
        <translation>une probabilité doit être un nombre fini</translation>
    </message>
    <message>
        <source>a probability cannot be negative</source>
        <translation>une probabilité ne peut être négative</translation>
    </message>
    <message>
        <source>all probabilities of the rule are zero</source>
        <translation>toutes les probabilités de la règle sont nulles</translation>
    </message>
    <message>
        <source>the probabilities add up to more than a number holds</source>
        <translation>la somme des probabilités dépasse ce qu’un nombre contient</translation>
    </message>
    <message>
        <source>there is no symbol before &quot;-&gt;&quot;</source>
        <translation>il n’y a pas de symbole avant «&#xa0;-&gt;&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;-&gt;&quot; must follow the symbol %1</source>
        <translation>«&#xa0;-&gt;&#xa0;» doit suivre le symbole %1</translation>
    </message>
    <message>
        <source>each choice needs a probability and a colon: &quot;0.5: text&quot;</source>
        <translation>chaque choix demande une probabilité et deux-points&#xa0;: «&#xa0;0.5: texte&#xa0;»</translation>
    </message>
    <message>
        <source>a second colon; write `: for the symbol</source>
        <translation>un deuxième deux-points&#xa0;; écrivez `: pour le symbole</translation>
    </message>
    <message>
        <source>the rule has two defaults</source>
        <translation>la règle a deux choix par défaut</translation>
    </message>
    <message>
        <source>the number %1 is out of all range</source>
        <translation>le nombre %1 est hors de toute limite</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a probability nor &quot;default&quot;</source>
        <translation>«&#xa0;%1&#xa0;» n’est ni une probabilité ni «&#xa0;default&#xa0;»</translation>
    </message>
    <message>
        <source>the symbol %1 already has a rule, in line %2</source>
        <translation>le symbole %1 a déjà une règle, à la ligne %2</translation>
    </message>
    <message>
        <source>a line feed cannot be a symbol</source>
        <translation>un saut de ligne ne peut être un symbole</translation>
    </message>
    <message>
        <source>the rule for %1 has %2 probabilities for %3 replacements</source>
        <translation>la règle de %1 a %2 probabilités pour %3 remplacements</translation>
    </message>
    <message>
        <source>iteration %1 of %2 would make more than %3 symbols; use fewer iterations or shorter rules</source>
        <translation>l’itération %1 sur %2 donnerait plus de %3 symboles&#xa0;; prenez moins d’itérations ou des règles plus courtes</translation>
    </message>
    <message>
        <source>brackets are nested deeper than %1</source>
        <translation>les crochets sont imbriqués sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>&quot;]&quot; without &quot;[&quot; before it, symbol %1 of the rewritten string</source>
        <translation>«&#xa0;]&#xa0;» sans «&#xa0;[&#xa0;» avant lui, symbole %1 de la chaîne réécrite</translation>
    </message>
    <message>
        <source>&quot;[&quot; is never closed, symbol %1 of the rewritten string</source>
        <translation>«&#xa0;[&#xa0;» jamais fermé, symbole %1 de la chaîne réécrite</translation>
    </message>
    <message>
        <source>the turtle&apos;s angle, step and taper must be finite numbers</source>
        <translation>l’angle, le pas et l’amincissement de la tortue doivent être des nombres finis</translation>
    </message>
    <message>
        <source>the turtle&apos;s step and taper cannot be negative</source>
        <translation>le pas et l’amincissement de la tortue ne peuvent être négatifs</translation>
    </message>
    <message>
        <source>the string draws %1 branches, more than the limit of %2</source>
        <translation>la chaîne trace %1 branches, plus que la limite de %2</translation>
    </message>
    <message>
        <source>the grammar draws no branch at all</source>
        <translation>la grammaire ne trace aucune branche</translation>
    </message>
    <message>
        <source>more than 1 GiB from a pipe or device</source>
        <translation>plus de 1 Gio depuis un tube ou un périphérique</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>three numbers expected, found &quot;%1&quot;</source>
        <translation>trois nombres attendus, trouvé «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>more than %1 vertices</source>
        <translation>plus de %1 sommets</translation>
    </message>
    <message>
        <source>vertex %1 does not exist (there are %2)</source>
        <translation>le sommet %1 n’existe pas (il y en a %2)</translation>
    </message>
    <message>
        <source>a corner v, v/vt, v//vn or v/vt/vn expected, found &quot;%1&quot;</source>
        <translation>un coin v, v/vt, v//vn ou v/vt/vn attendu, trouvé «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a face of fewer than three corners</source>
        <translation>une face de moins de trois coins</translation>
    </message>
    <message>
        <source>more than %1 triangles</source>
        <translation>plus de %1 triangles</translation>
    </message>
    <message>
        <source>not a line of an OBJ file: &quot;%1&quot;</source>
        <translation>ce n’est pas une ligne d’un fichier OBJ&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the file holds no vertices</source>
        <translation>le fichier ne contient aucun sommet</translation>
    </message>
    <message>
        <source>not a PLY file: it does not begin with &quot;ply&quot;</source>
        <translation>ce n’est pas un fichier PLY&#xa0;: il ne commence pas par «&#xa0;ply&#xa0;»</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>l’en-tête n’a pas de fin</translation>
    </message>
    <message>
        <source>the header states no format</source>
        <translation>l’en-tête n’indique pas de format</translation>
    </message>
    <message>
        <source>not a line of a PLY header: &quot;%1&quot;</source>
        <translation>ce n’est pas une ligne d’un en-tête PLY&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown format &quot;%1&quot;</source>
        <translation>format inconnu «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number of elements</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre d’éléments</translation>
    </message>
    <message>
        <source>two elements &quot;%1&quot;</source>
        <translation>deux éléments «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>more than %1 elements</source>
        <translation>plus de %1 éléments</translation>
    </message>
    <message>
        <source>a property before the first element</source>
        <translation>une propriété avant le premier élément</translation>
    </message>
    <message>
        <source>unknown type of property &quot;%1&quot;</source>
        <translation>type inconnu pour la propriété «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>two properties &quot;%1&quot;</source>
        <translation>deux propriétés «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>more than %1 properties</source>
        <translation>plus de %1 propriétés</translation>
    </message>
    <message>
        <source>the file is too short for %1 elements &quot;%2&quot;</source>
        <translation>le fichier est trop court pour %1 éléments «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>vertices without x, y and z</source>
        <translation>sommets sans x, y et z</translation>
    </message>
    <message>
        <source>vertex %1 is not a finite number</source>
        <translation>le sommet %1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>the faces&apos; vertices are no list of integers</source>
        <translation>les sommets des faces ne sont pas une liste d’entiers</translation>
    </message>
    <message>
        <source>face %1 has fewer than three corners</source>
        <translation>la face %1 a moins de trois coins</translation>
    </message>
    <message>
        <source>a number expected, found &quot;%1&quot;</source>
        <translation>un nombre attendu, trouvé «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a list of %1 values</source>
        <translation>une liste de %1 valeurs</translation>
    </message>
    <message>
        <source>the file ends within element %1 of &quot;%2&quot;</source>
        <translation>le fichier s’arrête dans l’élément %1 de «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>vertex %1 of %2 is not a finite number</source>
        <translation>le sommet %1 de %2 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>There must be one roll per branch</source>
        <translation>Il faut un roulis par branche</translation>
    </message>
    <message>
        <source>The mesh would have more than 2^31 faces</source>
        <translation>Le maillage aurait plus de 2^31 faces</translation>
    </message>
    <message>
        <source>the tree would carry more than %1 leaves</source>
        <translation>l’arbre porterait plus de %1 feuilles</translation>
    </message>
    <message>
        <source>the tree would carry more than %1 apples</source>
        <translation>l’arbre porterait plus de %1 pommes</translation>
    </message>
    <message>
        <source>Branch %1 has a coordinate or a radius that is not finite</source>
        <translation>La branche %1 a une coordonnée ou un rayon qui n’est pas fini</translation>
    </message>
    <message>
        <source>Branch %1 has a negative radius</source>
        <translation>La branche %1 a un rayon négatif</translation>
    </message>
    <message>
        <source>Branch %1 comes before its parent</source>
        <translation>La branche %1 vient avant son parent</translation>
    </message>
    <message>
        <source>Branch %1 is too large for a mesh</source>
        <translation>La branche %1 est trop grande pour un maillage</translation>
    </message>
    <message>
        <source>No branch of the skeleton has a length or a radius</source>
        <translation>Aucune branche du squelette n’a de longueur ni de rayon</translation>
    </message>
    <message>
        <source>The skeleton is too small for a mesh</source>
        <translation>Le squelette est trop petit pour un maillage</translation>
    </message>
    <message>
        <source>The skeleton has no branch</source>
        <translation>Le squelette n’a pas de branche</translation>
    </message>
    <message>
        <source>the mesh has too many faces to be checked</source>
        <translation>le maillage a trop de faces pour être vérifié</translation>
    </message>
    <message>
        <source>face %1 refers to a vertex that does not exist (%2 vertices)</source>
        <translation>la face %1 renvoie à un sommet qui n’existe pas (%2 sommets)</translation>
    </message>
    <message>
        <source>Grammar</source>
        <translation>Grammaire</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Tortue</translation>
    </message>
    <message>
        <source>Simplification</source>
        <translation>Simplification</translation>
    </message>
    <message>
        <source>Cross-sections</source>
        <translation>Sections</translation>
    </message>
    <message>
        <source>Foliage</source>
        <translation>Feuillage</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Placement</translation>
    </message>
    <message>
        <source>Axiom</source>
        <translation>Axiome</translation>
    </message>
    <message>
        <source>The seed the tree grows from: the symbols that stand there before any rule is used.</source>
        <translation>Le germe de l’arbre&#xa0;: les symboles présents avant toute règle.</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Règles</translation>
    </message>
    <message>
        <source>How symbols grow, one rule a line: &quot;A -&gt; [+A]B&quot; puts [+A]B in the place of every A. Several outcomes by chance: &quot;B -&gt; 0.7: B | 0.3: BB&quot;.</source>
        <translation>Comment poussent les symboles, une règle par ligne&#xa0;: «&#xa0;A -&gt; [+A]B&#xa0;» met [+A]B à la place de chaque A. Plusieurs issues au hasard&#xa0;: «&#xa0;B -&gt; 0.7: B | 0.3: BB&#xa0;».</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>How often the rules are used. Each round makes the tree finer; the number of branches grows quickly.</source>
        <translation>Combien de fois les règles s’appliquent. Chaque tour affine l’arbre&#xa0;; le nombre de branches croît vite.</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléatoire</translation>
    </message>
    <message>
        <source>Names one tree among all that chance can give. The same seed always grows the same tree.</source>
        <translation>Désigne un arbre parmi tous ceux que le hasard peut donner. La même graine donne toujours le même arbre.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>The angle of every turn a symbol asks for. Small angles give slender trees, large ones spreading trees.</source>
        <translation>L’angle de chaque rotation demandée par un symbole. Petit, il donne des arbres élancés&#xa0;; grand, des arbres étalés.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Length of each piece of branch, and the radius of the trunk at the ground. Leaves and apples take their size from it too: it scales the whole tree.</source>
        <translation>Longueur de chaque morceau de branche, et rayon du tronc au sol. Feuilles et pommes en tirent aussi leur taille&#xa0;: il règle l’échelle de tout l’arbre.</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Effilement</translation>
    </message>
    <message>
        <source>Share of the radius that remains at the end of each piece of branch. 1 keeps branches as thick as the trunk.</source>
        <translation>Part du rayon qui reste au bout de chaque morceau de branche. 1 garde les branches aussi épaisses que le tronc.</translation>
    </message>
    <message>
        <source>Merge straight runs</source>
        <translation>Fusionner les suites droites</translation>
    </message>
    <message>
        <source>Make one branch of pieces that follow each other without a turn. The shape stays, the mesh gets lighter.</source>
        <translation>Fait une seule branche des morceaux qui se suivent sans tourner. La forme reste, le maillage s’allège.</translation>
    </message>
    <message>
        <source>Straight below</source>
        <translation>Droit en dessous de</translation>
    </message>
    <message>
        <source>Pieces that turn by less than this angle count as straight and are merged. Larger angles remove bends too.</source>
        <translation>Les morceaux qui tournent de moins que cet angle comptent comme droits et sont fusionnés. Un angle plus grand supprime aussi des courbes.</translation>
    </message>
    <message>
        <source>Along the branch</source>
        <translation>Le long de la branche</translation>
    </message>
    <message>
        <source>Cross-sections of each branch, both ends included. More make smoother bends.</source>
        <translation>Sections de chaque branche, extrémités comprises. Plus il y en a, plus les courbes sont douces.</translation>
    </message>
    <message>
        <source>Around the branch</source>
        <translation>Autour de la branche</translation>
    </message>
    <message>
        <source>Points of each cross-section. More make rounder branches.</source>
        <translation>Points de chaque section. Plus il y en a, plus les branches sont rondes.</translation>
    </message>
    <message>
        <source>Twig thickness</source>
        <translation>Finesse des rameaux</translation>
    </message>
    <message>
        <source>Leaves per twig</source>
        <translation>Feuilles par rameau</translation>
    </message>
    <message>
        <source>Another seed arranges leaves and apples anew; the branches stay as they are.</source>
        <translation>Une autre graine redispose feuilles et pommes&#xa0;; les branches restent telles quelles.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position relative to the parent.</source>
        <translation>Position par rapport au parent.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>How it is turned: first about the parent&apos;s X axis, then Y, then Z. Y points up.</source>
        <translation>Comment il est tourné&#xa0;: d’abord autour de l’axe X du parent, puis Y, puis Z. Y pointe vers le haut.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>How large it is along its own axes; 1 is its natural size.</source>
        <translation>Sa taille le long de ses propres axes&#xa0;; 1 est sa taille naturelle.</translation>
    </message>
    <message>
        <source>must be between %1 and %2, not %3</source>
        <translation>doit être entre %1 et %2, pas %3</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>doit être un nombre fini</translation>
    </message>
    <message>
        <source>the text is longer than %1 bytes</source>
        <translation>le texte dépasse %1 octets</translation>
    </message>
    <message>
        <source>the text holds a zero byte</source>
        <translation>le texte contient un octet nul</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither true nor false</source>
        <translation>«&#xa0;%1&#xa0;» n’est ni vrai ni faux</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not three numbers with commas between</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas trois nombres séparés par des virgules</translation>
    </message>
    <message>
        <source>has a value of another type</source>
        <translation>a une valeur d’un autre type</translation>
    </message>
    <message>
        <source>A tree that forks in two, again and again</source>
        <translation>Un arbre qui fourche en deux, encore et encore</translation>
    </message>
    <message>
        <source>Slender branches with fans of twigs</source>
        <translation>Des branches élancées aux éventails de rameaux</translation>
    </message>
    <message>
        <source>A small tree, drawn once by chance and kept</source>
        <translation>Un petit arbre, tiré une fois au hasard et gardé</translation>
    </message>
    <message>
        <source>A fern that grows in one plane</source>
        <translation>Une fougère qui pousse dans un plan</translation>
    </message>
    <message>
        <source>there is no preset &quot;%1&quot;; there are %2</source>
        <translation>il n’y a pas de modèle «&#xa0;%1&#xa0;»&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>%1 branches would make a mesh of about %2 triangles, more than the limit of %3</source>
        <translation>%1 branches feraient un maillage d’environ %2 triangles, plus que la limite de %3</translation>
    </message>
    <message>
        <source>the place in the world is not a finite one</source>
        <translation>la place dans le monde n’est pas finie</translation>
    </message>
    <message>
        <source>the place in the world is a projection</source>
        <translation>la place dans le monde est une projection</translation>
    </message>
    <message>
        <source>the place in the world is flat: a scale is zero</source>
        <translation>la place dans le monde est plate&#xa0;: une échelle est nulle</translation>
    </message>
    <message>
        <source>the place in the world is sheared: no rotation and scale give it</source>
        <translation>la place dans le monde est cisaillée&#xa0;: aucune rotation et échelle ne la donnent</translation>
    </message>
    <message>
        <source>there is no node to insert</source>
        <translation>il n’y a pas de nœud à insérer</translation>
    </message>
    <message>
        <source>the parent of node %1 does not stand before it</source>
        <translation>le parent du nœud %1 n’est pas placé avant lui</translation>
    </message>
    <message>
        <source>another node has the id %1 as well</source>
        <translation>un autre nœud a aussi l’identifiant %1</translation>
    </message>
    <message>
        <source>a node cannot be moved below itself</source>
        <translation>un nœud ne peut être déplacé sous lui-même</translation>
    </message>
    <message>
        <source>%1 is no id of a node</source>
        <translation>%1 n’est pas un identifiant de nœud</translation>
    </message>
    <message>
        <source>the parents of node %1 go round in a circle</source>
        <translation>les parents du nœud %1 tournent en rond</translation>
    </message>
    <message>
        <source>this cannot be read as a number</source>
        <translation>ceci ne se lit pas comme un nombre</translation>
    </message>
    <message>
        <source>two units cannot be multiplied here</source>
        <translation>deux unités ne peuvent être multipliées ici</translation>
    </message>
    <message>
        <source>a unit cannot have a power here</source>
        <translation>une unité ne peut avoir de puissance ici</translation>
    </message>
    <message>
        <source>this number has a unit already</source>
        <translation>ce nombre a déjà une unité</translation>
    </message>
    <message>
        <source>unknown unit</source>
        <translation>unité inconnue</translation>
    </message>
    <message>
        <source>a number is missing here</source>
        <translation>il manque un nombre ici</translation>
    </message>
    <message>
        <source>The clipboard holds no copied parameters</source>
        <translation>Le presse-papiers ne contient pas de paramètres copiés</translation>
    </message>
    <message>
        <source>The picture&apos;s sides must be 1 to %1 pixels</source>
        <translation>Les côtés de l’image doivent mesurer de 1 à %1 pixels</translation>
    </message>
    <message>
        <source>No OpenGL 3.3 context is available here</source>
        <translation>Aucun contexte OpenGL 3.3 n’est disponible ici</translation>
    </message>
    <message>
        <source>The graphics driver refuses a picture of %1 x %2 pixels</source>
        <translation>Le pilote graphique refuse une image de %1 x %2 pixels</translation>
    </message>
    <message>
        <source>The graphics driver refuses a shader: %1</source>
        <translation>Le pilote graphique refuse un shader&#xa0;: %1</translation>
    </message>
    <message>
        <source>Pictures cannot be written as &apos;%1&apos;</source>
        <translation>Les images ne peuvent être écrites en «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>The graphics driver gave no picture</source>
        <translation>Le pilote graphique n’a donné aucune image</translation>
    </message>
    <message>
        <source>“%1” cannot be compared</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être comparé</translation>
    </message>
    <message>
        <source>a number is missing after “%1”</source>
        <translation>il manque un nombre après «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>it is a device, not a file</source>
        <translation>c’est un périphérique, pas un fichier</translation>
    </message>
    <message>
        <source>the mesh refers to something that it does not have</source>
        <translation>le maillage renvoie à quelque chose qui n’y est pas</translation>
    </message>
    <message>
        <source>once, loop or pingPong is expected here</source>
        <translation>once, loop ou pingPong est attendu ici</translation>
    </message>
    <message>
        <source>there must be 1 to 240 frames a second</source>
        <translation>il faut de 1 à 240 images par seconde</translation>
    </message>
    <message>
        <source>a frame must lie between %1 and %2</source>
        <translation>une image doit se situer entre %1 et %2</translation>
    </message>
    <message>
        <source>the last frame lies before the first</source>
        <translation>la dernière image précède la première</translation>
    </message>
    <message>
        <source>Faithful</source>
        <translation>Fidèle</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robuste</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Monde</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Physique</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Robust: damped springs that stay calm for every value. Faithful: the step of the reference, exactly, which large values make nervous.</source>
        <translation>Robuste&#xa0;: des ressorts amortis qui restent calmes pour toute valeur. Fidèle&#xa0;: exactement le pas de la référence, que de grandes valeurs rendent nerveux.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>How much time passes in each step of the motion. Short steps are more exact and take longer.</source>
        <translation>Le temps qui passe à chaque pas du mouvement. Des pas courts sont plus exacts et prennent plus longtemps.</translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation>Sous-pas</translation>
    </message>
    <message>
        <source>Into how many parts the robust mode divides each step. More follow a quick wind more closely. The faithful mode always takes whole steps.</source>
        <translation>En combien de parts le mode robuste divise chaque pas. Davantage de parts suivent de plus près un vent rapide. Le mode fidèle fait toujours des pas entiers.</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>Share of a movement that remains: close to 1 the tree swings for long, at 0 it follows the wind without swinging. Robust: the share after half a swing. Faithful: the share of the speed after each step.</source>
        <translation>Part d’un mouvement qui reste : près de 1 l’arbre se balance longtemps, à 0 il suit le vent sans se balancer. Robuste : la part après un demi-balancement. Fidèle : la part de la vitesse après chaque pas.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>How strongly branches want back to their place. Stiff ones bend less and swing faster.</source>
        <translation>La force avec laquelle les branches reviennent à leur place. Raides, elles plient moins et se balancent plus vite.</translation>
    </message>
    <message>
        <source>Back to</source>
        <translation>Retour vers</translation>
    </message>
    <message>
        <source>The rest position that a branch swings back to: its place relative to its parent, or its first direction in the world. The faithful mode always uses the world.</source>
        <translation>La position de repos vers laquelle une branche revient : sa place par rapport à son parent, ou sa direction initiale dans le monde. Le mode fidèle prend toujours le monde.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>Wind direction</source>
        <translation>Direction du vent</translation>
    </message>
    <message>
        <source>Direction that the wind blows to, as a turn about the vertical axis: 0 along X, a quarter turn against Z.</source>
        <translation>Direction vers laquelle souffle le vent, comme rotation autour de l’axe vertical : 0 le long de X, un quart de tour contre Z.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>How much the wind swells and dies down within seconds. Only in the robust mode.</source>
        <translation>Combien le vent s’enfle et retombe en quelques secondes. Seulement en mode robuste.</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulence</translation>
    </message>
    <message>
        <source>How much the wind differs from place to place, quickly, so that twigs flutter. Only in the robust mode.</source>
        <translation>Combien le vent diffère d’un endroit à l’autre, vite, si bien que les rameaux frémissent. Seulement en mode robuste.</translation>
    </message>
    <message>
        <source>Another seed gives other gusts and eddies. The same seed always gives the same motion.</source>
        <translation>Une autre graine donne d’autres rafales et remous. La même graine donne toujours le même mouvement.</translation>
    </message>
    <message>
        <source>Apples bounce</source>
        <translation>Rebond des pommes</translation>
    </message>
    <message>
        <source>Share of its speed with which a fallen apple bounces off the ground. At 0 it stays where it falls.</source>
        <translation>Part de sa vitesse avec laquelle une pomme tombée rebondit. À 0 elle reste où elle tombe.</translation>
    </message>
    <message>
        <source>Apple friction</source>
        <translation>Frottement des pommes</translation>
    </message>
    <message>
        <source>How strongly the ground slows a rolling apple: 0 it rolls on for ever.</source>
        <translation>La force avec laquelle le sol ralentit une pomme qui roule&#xa0;: 0 elle roule sans fin.</translation>
    </message>
    <message>
        <source>must be one of %1, not &quot;%2&quot;</source>
        <translation>doit être l’un de %1, et non «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Rigide</translation>
    </message>
    <message>
        <source>Linear blend</source>
        <translation>Mélange linéaire</translation>
    </message>
    <message>
        <source>Dual quaternion</source>
        <translation>Quaternion dual</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Courbures</translation>
    </message>
    <message>
        <source>How the bark follows moving branches at forks and bends. Rigid: every ring follows one branch. Linear blend: smooth, but strong bends get thin. Dual quaternion: smooth, and branches keep their thickness.</source>
        <translation>Comment l&apos;écorce suit les branches en mouvement aux fourches et aux courbures. Rigide : chaque anneau suit une seule branche. Mélange linéaire : lisse, mais les fortes courbures s&apos;amincissent. Quaternion dual : lisse, et les branches gardent leur épaisseur.</translation>
    </message>
    <message>
        <source>The mesh was not made of this skeleton</source>
        <translation>Le maillage n&apos;a pas été fait à partir de ce squelette</translation>
    </message>
    <message>
        <source>The mesh does not say which triangles belong to which tube</source>
        <translation>Le maillage ne dit pas quels triangles appartiennent à quel tube</translation>
    </message>
    <message>
        <source>The texture tile is too small for the tree</source>
        <translation>Le carreau de texture est trop petit pour l’arbre</translation>
    </message>
    <message>
        <source>not a file of baked motion</source>
        <translation>n’est pas un fichier de mouvement précalculé</translation>
    </message>
    <message>
        <source>baked motion of version %1; this program knows version %2</source>
        <translation>mouvement précalculé de version %1&#xa0;; ce programme connaît la version %2</translation>
    </message>
    <message>
        <source>the file is cut short, or something follows its end</source>
        <translation>le fichier est tronqué, ou quelque chose suit sa fin</translation>
    </message>
    <message>
        <source>the file is damaged: its checksum differs</source>
        <translation>le fichier est abîmé&#xa0;: sa somme de contrôle diffère</translation>
    </message>
    <message>
        <source>this motion was baked from another tree</source>
        <translation>ce mouvement a été précalculé pour un autre arbre</translation>
    </message>
    <message>
        <source>the file holds values that cannot be</source>
        <translation>le fichier contient des valeurs impossibles</translation>
    </message>
    <message>
        <source>step %1 is outside 0 to %2</source>
        <translation>le pas %1 n’est pas entre 0 et %2</translation>
    </message>
    <message>
        <source>So many branches cannot be drawn with the triangle budget: this is their smallest mesh</source>
        <translation>Tant de branches ne tiennent pas dans le budget de triangles&#xa0;: voici leur plus petit maillage</translation>
    </message>
    <message>
        <source>The triangle budget is more than these branches can take: this is their finest mesh</source>
        <translation>Le budget de triangles dépasse ce que ces branches peuvent recevoir&#xa0;: voici leur maillage le plus fin</translation>
    </message>
    <message>
        <source>No mesh fits the triangle budget: this is the nearest</source>
        <translation>Aucun maillage ne correspond au budget de triangles&#xa0;: voici le plus proche</translation>
    </message>
    <message>
        <source>Triangle budget</source>
        <translation>Budget de triangles</translation>
    </message>
    <message>
        <source>About how many triangles all branches may take together, within 5 %. Thick and bent branches get more of them, thin and straight ones fewer, and the two numbers above have no say. 0 sets no budget.</source>
        <translation>Nombre approximatif de triangles de toutes les branches réunies, à 5&#xa0;% près. Les branches épaisses et courbées en reçoivent plus, les fines et les droites moins, et les deux nombres ci-dessus ne comptent plus. 0&#xa0;: pas de budget.</translation>
    </message>
    <message>
        <source>the time is too late for the physics</source>
        <translation>ce moment est trop tardif pour la physique</translation>
    </message>
    <message>
        <source>three numbers are expected here</source>
        <translation>trois nombres sont attendus ici</translation>
    </message>
    <message>
        <source>the tree was changed meanwhile</source>
        <translation>l’arbre a été modifié entre-temps</translation>
    </message>
    <message>
        <source>a texture coordinate of %1 is not a finite number</source>
        <translation>une coordonnée de texture de %1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>Bark tile</source>
        <translation>Carreau d’écorce</translation>
    </message>
    <message>
        <source>An angle must be a number</source>
        <translation>Un angle doit être un nombre</translation>
    </message>
    <message>
        <source>The lower limit of an angle must not be over the upper one</source>
        <translation>La limite inférieure d&apos;un angle ne doit pas dépasser la limite supérieure</translation>
    </message>
    <message>
        <source>A speed limit must not be negative</source>
        <translation>Une limite de vitesse ne doit pas être négative</translation>
    </message>
    <message>
        <source>An arm has 1 to 64 joints</source>
        <translation>Un bras a de 1 à 64 articulations</translation>
    </message>
    <message>
        <source>A segment must be longer than 0</source>
        <translation>Un segment doit être plus long que 0</translation>
    </message>
    <message>
        <source>The time must be a number of seconds, at most a day</source>
        <translation>Le temps doit être un nombre de secondes, au plus un jour</translation>
    </message>
    <message>
        <source>there is not enough memory for this</source>
        <translation>il n’y a pas assez de mémoire pour cela</translation>
    </message>
    <message>
        <source>a file of this name is there that is no baked motion: it stays</source>
        <translation>un fichier de ce nom existe, qui n’est pas un mouvement précalculé : il reste</translation>
    </message>
    <message>
        <source>there is no visible tree to bake</source>
        <translation>il n’y a pas d’arbre visible à précalculer</translation>
    </message>
    <message>
        <source>baked motion lies beside the project: save that first</source>
        <translation>le mouvement précalculé se place à côté du projet : enregistrez d’abord celui-ci</translation>
    </message>
    <message>
        <source>the range ends at frame 0 or before, where trees rest</source>
        <translation>la plage s’arrête à l’image 0 ou avant, où les arbres sont au repos</translation>
    </message>
    <message>
        <source>cannot be deleted: %1</source>
        <translation>suppression impossible : %1</translation>
    </message>
    <message>
        <source>this motion was baked with other parameters</source>
        <translation>ce mouvement a été précalculé avec d’autres paramètres</translation>
    </message>
    <message>
        <source>there is no track &quot;%1&quot; for this kind of node</source>
        <translation>il n&apos;y a pas de piste «&#xa0;%1&#xa0;» pour ce genre de nœud</translation>
    </message>
    <message>
        <source>there is no key %1</source>
        <translation>il n&apos;y a pas de clé %1</translation>
    </message>
    <message>
        <source>the time lies beyond a million seconds</source>
        <translation>le temps est au-delà d&apos;un million de secondes</translation>
    </message>
    <message>
        <source>must be a finite number that is not negative</source>
        <translation>doit être un nombre fini qui n&apos;est pas négatif</translation>
    </message>
    <message>
        <source>must be finite numbers</source>
        <translation>doivent être des nombres finis</translation>
    </message>
    <message>
        <source>a quaternion of this length has no direction</source>
        <translation>un quaternion de cette longueur n&apos;a pas de direction</translation>
    </message>
    <message>
        <source>base64 of rows of three numbers of 32 bits is expected here</source>
        <translation>on attend ici en base64 des rangées de trois nombres de 32 bits</translation>
    </message>
    <message>
        <source>there must be one for each position</source>
        <translation>il en faut une pour chaque position</translation>
    </message>
    <message>
        <source>there is no vertex %1</source>
        <translation>il n&apos;y a pas de sommet %1</translation>
    </message>
    <message>
        <source>one of %1 is expected here</source>
        <translation>on attend ici l&apos;un de %1</translation>
    </message>
    <message>
        <source>four pairs of numbers are expected here</source>
        <translation>on attend ici quatre paires de nombres</translation>
    </message>
    <message>
        <source>an array of %1 numbers is expected here</source>
        <translation>on attend ici un tableau de %1 nombres</translation>
    </message>
    <message>
        <source>a key has nothing of this name</source>
        <translation>une clé n&apos;a rien de ce nom</translation>
    </message>
    <message>
        <source>the time must lie behind that of the key before</source>
        <translation>le temps doit suivre celui de la clé précédente</translation>
    </message>
    <message>
        <source>a loop takes time</source>
        <translation>une boucle prend du temps</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no such track</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;a pas une telle piste</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cône</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Frame cross</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Own shape</source>
        <translation>Forme propre</translation>
    </message>
    <message>
        <source>Primitive</source>
        <translation>Primitive</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Own position</source>
        <translation>Position propre</translation>
    </message>
    <message>
        <source>Moves the node&apos;s own shape, but not its children.</source>
        <translation>Déplace la forme du nœud lui-même, mais pas ses enfants.</translation>
    </message>
    <message>
        <source>Own rotation</source>
        <translation>Rotation propre</translation>
    </message>
    <message>
        <source>Turns the node&apos;s own shape, but not its children: first about X, then Y, then Z.</source>
        <translation>Tourne la forme du nœud lui-même, mais pas ses enfants : d’abord autour de X, puis Y, puis Z.</translation>
    </message>
    <message>
        <source>Own scale</source>
        <translation>Échelle propre</translation>
    </message>
    <message>
        <source>Scales the node&apos;s own shape, but not its children.</source>
        <translation>Étire la forme du nœud lui-même, mais pas ses enfants.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Which solid it is. Cylinders and cones stand on their origin, the others lie about it.</source>
        <translation>Quel solide c&apos;est. Les cylindres et les cônes se dressent sur leur origine, les autres l&apos;entourent.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Radius of cylinders, cones and spheres. For a frame cross, the thickness of its arrows.</source>
        <translation>Rayon des cylindres, cônes et sphères. Pour un repère, l’épaisseur de ses flèches.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Length of cylinders and cones along their axis. For a frame cross, the length of its arrows.</source>
        <translation>Longueur des cylindres et des cônes le long de leur axe. Pour un repère, la longueur de ses flèches.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Width, height and depth of a box; of a plane the first and the last.</source>
        <translation>Largeur, hauteur et profondeur d&apos;une boîte ; d&apos;un plan, la première et la dernière.</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Côtés</translation>
    </message>
    <message>
        <source>How many sides make a circle. More make it rounder.</source>
        <translation>Combien de côtés font un cercle. Davantage le rendent plus rond.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Along which of its own axes it stands.</source>
        <translation>Le long duquel de ses propres axes il se dresse.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Red, green and blue of the surface, each from 0 to 1.</source>
        <translation>Rouge, vert et bleu de la surface, chacun de 0 à 1.</translation>
    </message>
    <message>
        <source>frames of a sequence are numbered from 0 on</source>
        <translation>les images d’une suite sont numérotées à partir de 0</translation>
    </message>
    <message>
        <source>the step must be at least one frame</source>
        <translation>le pas doit être d’au moins une image</translation>
    </message>
    <message>
        <source>a sequence has at most %1 frames</source>
        <translation>une suite a au plus %1 images</translation>
    </message>
    <message>
        <source>The graphics driver cannot draw beside the window: `ramure-cli render` writes the same pictures</source>
        <translation>Le pilote graphique ne peut pas dessiner à côté de la fenêtre : `ramure-cli render` écrit les mêmes images</translation>
    </message>
    <message>
        <source>cannot be encoded: %1</source>
        <translation>encodage impossible : %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no arm</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un bras</translation>
    </message>
    <message>
        <source>nothing of this name is expected here</source>
        <translation>rien de ce nom n&apos;est attendu ici</translation>
    </message>
    <message>
        <source>Damped least squares</source>
        <translation>Moindres carrés amortis</translation>
    </message>
    <message>
        <source>Jacobian transpose</source>
        <translation>Transposée de la jacobienne</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Inverse kinematics</source>
        <translation>Cinématique inverse</translation>
    </message>
    <message>
        <source>Skin of the arm</source>
        <translation>Peau du bras</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terrain</translation>
    </message>
    <message>
        <source>Follows the target</source>
        <translation>Suit la cible</translation>
    </message>
    <message>
        <source>Inverse kinematics turns the joints until the tip is at the target. Otherwise the angles stay.</source>
        <translation>La cinématique inverse tourne les articulations jusqu&apos;à ce que le bout soit à la cible. Sinon les angles restent.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Position that the tip moves to, in the arm&apos;s own space: its foot at 0, Z up.</source>
        <translation>Position où va le bout, dans l’espace du bras : son pied en 0, Z vers le haut.</translation>
    </message>
    <message>
        <source>Joint size</source>
        <translation>Taille des articulations</translation>
    </message>
    <message>
        <source>Radius of the spheres at the joints.</source>
        <translation>Rayon des sphères aux articulations.</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solveur</translation>
    </message>
    <message>
        <source>Damped least squares keeps to the limits and reaches nearly everything in a few steps. Jacobian transpose goes downhill in many small ones.</source>
        <translation>Les moindres carrés amortis respectent les limites et atteignent presque tout en quelques pas. La transposée de la jacobienne descend la pente par beaucoup de petits pas.</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>Taille du pas</translation>
    </message>
    <message>
        <source>Jacobian transpose only: how far each step goes. Too much, and the arm shakes.</source>
        <translation>Transposée de la jacobienne seulement : jusqu&apos;où va chaque pas. Trop grand, le bras tremble.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Jacobian transpose only: steps for each sixtieth of a second.</source>
        <translation>Transposée de la jacobienne seulement : pas par soixantième de seconde.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Nearer than this, the target counts as reached.</source>
        <translation>Plus près que cela, la cible compte comme atteinte.</translation>
    </message>
    <message>
        <source>Radius of the cylinder around the arm.</source>
        <translation>Rayon du cylindre autour du bras.</translation>
    </message>
    <message>
        <source>Divisions along</source>
        <translation>Divisions en longueur</translation>
    </message>
    <message>
        <source>Cells of the skin&apos;s grid along the arm.</source>
        <translation>Mailles de la peau le long du bras.</translation>
    </message>
    <message>
        <source>Divisions around</source>
        <translation>Divisions autour</translation>
    </message>
    <message>
        <source>Cells of the skin&apos;s grid around the arm.</source>
        <translation>Mailles de la peau autour du bras.</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>How far on either side of a joint two segments share the skin; at most half a segment.</source>
        <translation>Jusqu&apos;où, de chaque côté d&apos;une articulation, deux segments partagent la peau ; au plus un demi-segment.</translation>
    </message>
    <message>
        <source>Another seed, another terrain.</source>
        <translation>Une autre graine, un autre terrain.</translation>
    </message>
    <message>
        <source>Length of a side.</source>
        <translation>Longueur d&apos;un côté.</translation>
    </message>
    <message>
        <source>How far the widest hills rise and fall.</source>
        <translation>Jusqu&apos;où montent et descendent les plus larges collines.</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosité</translation>
    </message>
    <message>
        <source>How high hills of half the width are, compared with the wider ones.</source>
        <translation>Hauteur des collines deux fois moins larges, par rapport aux plus larges.</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Divisions</translation>
    </message>
    <message>
        <source>Cells of the grid along a side.</source>
        <translation>Mailles de la grille par côté.</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Shows the skin; without it, joints and rods.</source>
        <translation>Montre la peau ; sans elle, les articulations et les tiges.</translation>
    </message>
    <message>
        <source>Show weights</source>
        <translation>Montrer les poids</translation>
    </message>
    <message>
        <source>Colours the skin by the segments that it follows.</source>
        <translation>Colore la peau selon les segments qu&apos;elle suit.</translation>
    </message>
    <message>
        <source>Forks</source>
        <translation>Fourches</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>How far wood grows over the creases between the branches of a fork: 0 leaves them sharp, 1 rounds them fully.</source>
        <translation>Jusqu&apos;où le bois recouvre les plis entre les branches d&apos;une fourche : 0 les laisse vifs, 1 les arrondit tout à fait.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>How far from the crease the branches of a fork begin to swell, as a share of the thinner one&apos;s radius.</source>
        <translation>À quelle distance du pli les branches d&apos;une fourche commencent à grossir, en part du rayon de la plus mince.</translation>
    </message>
    <message>
        <source>Calm short branches</source>
        <translation>Calmer les branches courtes</translation>
    </message>
    <message>
        <source>A branch much shorter than its parent swings out in a wide bow before it turns to its own direction. On: the bow is no larger than one and a half times the branch.</source>
        <translation>Une branche bien plus courte que sa branche mère décrit un grand arc avant de prendre sa propre direction. Activé : l&apos;arc ne dépasse pas une fois et demie la branche.</translation>
    </message>
    <message>
        <source>Join twins below</source>
        <translation>Réunir les jumelles sous</translation>
    </message>
    <message>
        <source>Branches of a fork become one where their ends are closer than this share of their added radii: they would lie in each other all along. 0 joins only those in the same place.</source>
        <translation>Les branches d&apos;une fourche n&apos;en font qu&apos;une si leurs extrémités sont plus proches que cette part de la somme de leurs rayons : elles seraient l&apos;une dans l&apos;autre sur toute leur longueur. 0 ne réunit que celles qui coïncident.</translation>
    </message>
    <message>
        <source>no selected node has tracks for these keys</source>
        <translation>aucun nœud sélectionné n’a de pistes pour ces clés</translation>
    </message>
    <message>
        <source>%1 columns, %2 are expected: time,MODE and ten numbers with decimal points</source>
        <translation>%1 colonnes, on en attend %2 : temps,MODE et dix nombres à point décimal</translation>
    </message>
    <message>
        <source>CUBIC is read as the spline through the keys, not as Blender&apos;s easing</source>
        <translation>CUBIC est lu comme la courbe passant par les clés, non comme l&apos;accélération de Blender</translation>
    </message>
    <message>
        <source>the mode &quot;%1&quot; is not known: read as a CUBIC spline</source>
        <translation>le mode « %1 » est inconnu : lu comme une courbe CUBIC</translation>
    </message>
    <message>
        <source>the easing &quot;%1&quot; is not known: read as AUTO</source>
        <translation>l&apos;accélération « %1 » est inconnue : lue comme AUTO</translation>
    </message>
    <message>
        <source>a quaternion is no unit: only its direction counts</source>
        <translation>un quaternion n&apos;est pas unitaire : seule sa direction compte</translation>
    </message>
    <message>
        <source>two keys at one time: the last counts</source>
        <translation>deux clés au même temps : la dernière compte</translation>
    </message>
    <message>
        <source>the keys are not in order: sorted by time</source>
        <translation>les clés ne sont pas dans l&apos;ordre : triées par temps</translation>
    </message>
    <message>
        <source>the file has no keys: the object does not move</source>
        <translation>le fichier n&apos;a pas de clés : l&apos;objet ne bouge pas</translation>
    </message>
    <message>
        <source>BEZIER without handles: they are set as Blender sets them for new keys</source>
        <translation>BEZIER sans poignées : elles sont posées comme Blender les pose pour de nouvelles clés</translation>
    </message>
    <message>
        <source>the loop jumps: its last key is not the first one</source>
        <translation>la boucle saute : sa dernière clé n&apos;est pas la première</translation>
    </message>
    <message>
        <source>this kind of node has no place in the format: left out</source>
        <translation>ce genre de nœud n&apos;a pas de place dans le format : omis</translation>
    </message>
    <message>
        <source>there is no object to export</source>
        <translation>il n&apos;y a pas d&apos;objet à exporter</translation>
    </message>
    <message>
        <source>tracks of the own shape and of parameters have no place in the format</source>
        <translation>les pistes de la forme propre et des paramètres n&apos;ont pas de place dans le format</translation>
    </message>
    <message>
        <source>the keys differ between the channels: written frame by frame</source>
        <translation>les clés diffèrent entre les canaux : écrites image par image</translation>
    </message>
    <message>
        <source>TRANSFORM stands twice: the last counts</source>
        <translation>TRANSFORM figure deux fois : le dernier compte</translation>
    </message>
    <message>
        <source>TRANSFORM has %1 numbers, 16 are expected</source>
        <translation>TRANSFORM a %1 nombres, on en attend 16</translation>
    </message>
    <message>
        <source>the last row of TRANSFORM must be 0 0 0 1</source>
        <translation>la dernière ligne de TRANSFORM doit être 0 0 0 1</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>le fichier ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>le fichier ne peut pas être lu</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>le dossier ne peut pas être lu</translation>
    </message>
    <message>
        <source>the folder has no .obj and no .animation</source>
        <translation>le dossier n&apos;a ni .obj ni .animation</translation>
    </message>
    <message>
        <source>there is no .obj of this name: a group that moves</source>
        <translation>il n&apos;y a pas de .obj de ce nom : un groupe qui bouge</translation>
    </message>
    <message>
        <source>there is no TRANSFORM: the object stands at the origin</source>
        <translation>il n&apos;y a pas de TRANSFORM : l&apos;objet est à l&apos;origine</translation>
    </message>
    <message>
        <source>the TRANSFORM shears, mirrors or flattens: it was put into the vertices</source>
        <translation>le TRANSFORM cisaille, reflète ou aplatit : il a été appliqué aux sommets</translation>
    </message>
    <message>
        <source>the parent &quot;%1&quot; cannot be: the object is at the top</source>
        <translation>le parent « %1 » est impossible : l&apos;objet est au premier niveau</translation>
    </message>
    <message>
        <source>no file names a parent: all objects stand side by side</source>
        <translation>aucun fichier ne nomme de parent : tous les objets sont côte à côte</translation>
    </message>
    <message>
        <source>no file says the frame rate: %1 frames a second are taken</source>
        <translation>aucun fichier ne dit la cadence : on prend %1 images par seconde</translation>
    </message>
    <message>
        <source>Moving cylinder</source>
        <translation>Cylindre mobile</translation>
    </message>
    <message>
        <source>Moving tree</source>
        <translation>Arbre mobile</translation>
    </message>
    <message>
        <source>Articulated arm</source>
        <translation>Bras articulé</translation>
    </message>
    <message>
        <source>unknown demo &quot;%1&quot;: one of %2 expected</source>
        <translation>démonstration « %1 » inconnue : on attend l&apos;une de %2</translation>
    </message>
    <message>
        <source>the arm follows no target: there is no motion to bake</source>
        <translation>le bras ne suit aucune cible : il n&apos;y a pas de mouvement à transformer</translation>
    </message>
    <message>
        <source>a tolerance must not be negative</source>
        <translation>une tolérance ne doit pas être négative</translation>
    </message>
    <message>
        <source>the arm was changed meanwhile</source>
        <translation>le bras a été modifié entre-temps</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no joint %2</source>
        <translation>« %1 » n&apos;a pas d&apos;articulation %2</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of the segment behind the joint, in metres</source>
        <translation>Longueur du segment qui suit l’articulation, en mètres</translation>
    </message>
    <message>
        <source>Phi</source>
        <translation>Phi</translation>
    </message>
    <message>
        <source>Turns about the segment before the joint, degrees</source>
        <translation>Tourne autour du segment qui précède l&apos;articulation, en degrés</translation>
    </message>
    <message>
        <source>Phi from</source>
        <translation>Phi de</translation>
    </message>
    <message>
        <source>Lower limit of phi, degrees</source>
        <translation>Limite inférieure de phi, en degrés</translation>
    </message>
    <message>
        <source>Phi to</source>
        <translation>Phi à</translation>
    </message>
    <message>
        <source>Upper limit of phi, degrees</source>
        <translation>Limite supérieure de phi, en degrés</translation>
    </message>
    <message>
        <source>Phi speed</source>
        <translation>Vitesse de phi</translation>
    </message>
    <message>
        <source>The most phi turns, degrees a second; 0 is as fast as it likes</source>
        <translation>Vitesse maximale de phi, en degrés par seconde ; 0 : sans limite</translation>
    </message>
    <message>
        <source>Theta</source>
        <translation>Thêta</translation>
    </message>
    <message>
        <source>Bends the arm about the joint&apos;s Y axis, degrees</source>
        <translation>Plie le bras autour de l&apos;axe Y de l&apos;articulation, en degrés</translation>
    </message>
    <message>
        <source>Theta from</source>
        <translation>Thêta de</translation>
    </message>
    <message>
        <source>Lower limit of theta, degrees</source>
        <translation>Limite inférieure de thêta, en degrés</translation>
    </message>
    <message>
        <source>Theta to</source>
        <translation>Thêta à</translation>
    </message>
    <message>
        <source>Upper limit of theta, degrees</source>
        <translation>Limite supérieure de thêta, en degrés</translation>
    </message>
    <message>
        <source>Theta speed</source>
        <translation>Vitesse de thêta</translation>
    </message>
    <message>
        <source>The most theta turns, degrees a second; 0 is as fast as it likes</source>
        <translation>Vitesse maximale de thêta, en degrés par seconde ; 0 : sans limite</translation>
    </message>
    <message>
        <source>the mesh has no triangles: an arm cannot wear it</source>
        <translation>le maillage n&apos;a pas de triangles : un bras ne peut pas le porter</translation>
    </message>
    <message>
        <source>an arm wears a mesh of at most ten million vertices</source>
        <translation>un bras porte un maillage d&apos;au plus dix millions de sommets</translation>
    </message>
    <message>
        <source>a triangle of the mesh has a vertex that there is not</source>
        <translation>un triangle du maillage a un sommet qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>the mesh has positions that are not finite</source>
        <translation>le maillage a des positions qui ne sont pas finies</translation>
    </message>
    <message>
        <source>a scale of zero leaves nothing to wear</source>
        <translation>une échelle nulle ne laisse rien à porter</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no imported mesh</source>
        <translation>« %1 » n&apos;est pas un maillage importé</translation>
    </message>
    <message>
        <source>there is nothing visible to export</source>
        <translation>il n&apos;y a rien de visible à exporter</translation>
    </message>
    <message>
        <source>base64 of rows of two numbers of 32 bits is expected here</source>
        <translation>on attend ici du base64 de rangées de deux nombres de 32 bits</translation>
    </message>
    <message>
        <source>there must be three for each triangle</source>
        <translation>il en faut trois pour chaque triangle</translation>
    </message>
    <message>
        <source>there is no texture coordinate %1</source>
        <translation>il n&apos;y a pas de coordonnée de texture %1</translation>
    </message>
    <message>
        <source>the placement&apos;s own scale is 0</source>
        <translation>l’échelle propre du placement est nulle</translation>
    </message>
    <message>
        <source>the last frame must not stand before the first one</source>
        <translation>la dernière image ne doit pas précéder la première</translation>
    </message>
    <message>
        <source>there must be at least one frame from key to key</source>
        <translation>il faut au moins une image d’une clé à la suivante</translation>
    </message>
    <message>
        <source>&quot;%1&quot; wears no mesh</source>
        <translation>«&#xa0;%1&#xa0;» ne porte aucun maillage</translation>
    </message>
    <message>
        <source>another mesh is being put on</source>
        <translation>un autre maillage est en train d’être mis</translation>
    </message>
    <message>
        <source>How heavy everything is: 1 as on Earth, 0 weightless. Apples fall, and branches sag unless the tree starts settled.</source>
        <translation>Le poids de toute chose&#xa0;: 1 comme sur Terre, 0 en apesanteur. Les pommes tombent, et les branches ploient sauf si l’arbre part équilibré.</translation>
    </message>
    <message>
        <source>Starts settled</source>
        <translation>Part équilibré</translation>
    </message>
    <message>
        <source>The shape as modelled already hangs under its own weight, and motion starts from rest. Off: the weight comes on when motion starts, and branches sag. Only in the robust mode.</source>
        <translation>La forme modelée porte déjà son propre poids, et le mouvement part du repos. Sans cela, le poids n’agit qu’au départ du mouvement, et les branches ploient. Seulement en mode robuste.</translation>
    </message>
    <message>
        <source>nothing can vary: no rule has chances, and the variation of angles, lengths and radii is 0 %</source>
        <translation>rien ne peut varier : aucune règle ne comporte de hasard, et la variation des angles, longueurs et rayons est de 0 %</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Let chance choose among the outcomes of a rule and vary the branches, so that every seed gives another tree. Off: each rule always gives its default, and nothing varies.</source>
        <translation>Laisser le hasard choisir parmi les issues d’une règle et faire varier les branches : chaque graine donne un autre arbre. Sinon, chaque règle donne toujours son issue par défaut, et rien ne varie.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>How far each turn of a tree grown by chance may lie from the angle above, by seed. 0: every turn is the same.</source>
        <translation>De combien chaque rotation d’un arbre tiré au hasard peut s’écarter de l’angle ci-dessus, selon la graine. 0 : toutes les rotations sont égales.</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>How far each piece of branch of a tree grown by chance may be longer or shorter than the step, by seed.</source>
        <translation>De combien chaque morceau de branche d’un arbre tiré au hasard peut être plus long ou plus court que le pas, selon la graine.</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Rayons</translation>
    </message>
    <message>
        <source>How far each piece of branch of a tree grown by chance may taper more or less than the taper says, by seed. No branch gets thicker towards its tip.</source>
        <translation>De combien chaque morceau de branche d’un arbre tiré au hasard peut s’amincir plus ou moins que l’amincissement ne le dit, selon la graine. Aucune branche ne s’épaissit vers son bout.</translation>
    </message>
    <message>
        <source>The clipboard holds no value of this kind</source>
        <translation>Le presse-papiers ne contient pas de valeur de ce type</translation>
    </message>
    <message>
        <source>there are nine places for views</source>
        <translation>il y a neuf places pour les vues</translation>
    </message>
    <message>
        <source>a camera cannot stand like that</source>
        <translation>une caméra ne peut pas se tenir ainsi</translation>
    </message>
    <message>
        <source>Seed of the tree</source>
        <translation>Graine de l’arbre</translation>
    </message>
    <message>
        <source>Seed of the leaves</source>
        <translation>Graine des feuilles</translation>
    </message>
    <message>
        <source>Mass of an apple</source>
        <translation>Masse d’une pomme</translation>
    </message>
    <message>
        <source>Added to the branch that carries it. A branch itself counts as many kilograms as the radius of its end has metres.</source>
        <translation>Ajoutée à la branche qui la porte. Une branche compte elle-même autant de kilogrammes que le rayon de son bout a de mètres.</translation>
    </message>
    <message>
        <source>How strong the wind is, as a factor: 0 is calm, 1 a gentle breeze of 4 m/s on average. The faithful mode multiplies the wind of the reference by it.</source>
        <translation>La force du vent, comme facteur : 0 est le calme, 1 une petite brise de 4 m/s en moyenne. Le mode fidèle multiplie par lui le vent de la référence.</translation>
    </message>
    <message>
        <source>Seed of the wind</source>
        <translation>Graine du vent</translation>
    </message>
    <message>
        <source>Seed of the hills</source>
        <translation>Graine des collines</translation>
    </message>
    <message>
        <source>base64 of rows of three bytes is expected here</source>
        <translation>du base64 de lignes de trois octets est attendu ici</translation>
    </message>
    <message>
        <source>an object with keys has Y up and metres: they cannot be chosen</source>
        <translation>un objet à clés est en mètres, Y vers le haut : cela ne se choisit pas</translation>
    </message>
    <message>
        <source>unknown axis &quot;%1&quot;: y or z expected</source>
        <translation>axe inconnu « %1 » : y ou z attendu</translation>
    </message>
    <message>
        <source>unknown unit &quot;%1&quot;: one of %2 expected</source>
        <translation>unité inconnue « %1 » : une de %2 attendue</translation>
    </message>
    <message>
        <source>the scale must be from %1 to %2</source>
        <translation>l&apos;échelle doit être comprise entre %1 et %2</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>le fichier est trop gros</translation>
    </message>
    <message>
        <source>The longest</source>
        <translation>Le plus long</translation>
    </message>
    <message>
        <source>Axis of the mesh</source>
        <translation>Axe du maillage</translation>
    </message>
    <message>
        <source>Which axis of an object comes to lie along the arm when the arm puts it on: Y for a tree.</source>
        <translation>L&apos;axe d&apos;un objet qui vient s&apos;aligner sur le bras quand le bras le revêt : Y pour un arbre.</translation>
    </message>
    <message>
        <source>Keys from Blender</source>
        <translation>Clés de Blender</translation>
    </message>
    <message>
        <source>unknown file ending &quot;%1&quot;: meshes are written as %2</source>
        <translation>extension inconnue « %1 » : les maillages s’écrivent en %2</translation>
    </message>
    <message>
        <source>unknown file ending &quot;%1&quot;: %2 can be read</source>
        <translation>extension inconnue « %1 » : %2 peuvent être lus</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Wavefront OBJ, with materials</source>
        <translation>Wavefront OBJ, avec matériaux</translation>
    </message>
    <message>
        <source>Stanford PLY</source>
        <translation>Stanford PLY</translation>
    </message>
    <message>
        <source>PLY, binary</source>
        <translation>PLY, binaire</translation>
    </message>
    <message>
        <source>PLY, text</source>
        <translation>PLY, texte</translation>
    </message>
    <message>
        <source>cannot be written: is the disk full?</source>
        <translation>écriture impossible&#xa0;: le disque est-il plein&#xa0;?</translation>
    </message>
    <message>
        <source>unexpected error: %1</source>
        <translation>erreur inattendue : %1</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>le bras</translation>
    </message>
    <message>
        <source>Arm: %1</source>
        <translation>Bras : %1</translation>
    </message>
    <message>
        <source>Arms</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>&amp;Bras</translation>
    </message>
    <message>
        <source>Add an articulated arm that reaches for targets</source>
        <translation>Ajouter un bras articulé qui atteint des cibles</translation>
    </message>
    <message>
        <source>group</source>
        <translation>le groupe</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>Groupe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Groupe</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>le maillage</translation>
    </message>
    <message>
        <source>Imported mesh: %1</source>
        <translation>Maillage importé : %1</translation>
    </message>
    <message>
        <source>Imported meshes</source>
        <translation>Maillages importés</translation>
    </message>
    <message>
        <source>primitive</source>
        <translation>la primitive</translation>
    </message>
    <message>
        <source>Primitive: %1</source>
        <translation>Primitive : %1</translation>
    </message>
    <message>
        <source>Primitives</source>
        <translation>Primitives</translation>
    </message>
    <message>
        <source>terrain</source>
        <translation>le terrain</translation>
    </message>
    <message>
        <source>Terrain: %1</source>
        <translation>Terrain : %1</translation>
    </message>
    <message>
        <source>Terrains</source>
        <translation>Terrains</translation>
    </message>
    <message>
        <source>&amp;Terrain</source>
        <translation>&amp;Terrain</translation>
    </message>
    <message>
        <source>Add a terrain that gives an arm targets</source>
        <translation>Ajouter un terrain qui donne des cibles à un bras</translation>
    </message>
    <message>
        <source>tree</source>
        <translation>l’arbre</translation>
    </message>
    <message>
        <source>Tree: %1</source>
        <translation>Arbre&#xa0;: %1</translation>
    </message>
    <message>
        <source>A branch is divided into %1 to %2 cross-sections of %3 to %4 points</source>
        <translation>Une branche est divisée en %1 à %2 sections de %3 à %4 points</translation>
    </message>
    <message>
        <source>A roll is not a usable number</source>
        <translation>Un roulis n’est pas un nombre utilisable</translation>
    </message>
    <message>
        <source>Beech</source>
        <translation>Hêtre</translation>
    </message>
    <message>
        <source>Elm</source>
        <translation>Orme</translation>
    </message>
    <message>
        <source>Cherry</source>
        <translation>Cerisier</translation>
    </message>
    <message>
        <source>Magnolia</source>
        <translation>Magnolia</translation>
    </message>
    <message>
        <source>Boxwood</source>
        <translation>Buis</translation>
    </message>
    <message>
        <source>Birch</source>
        <translation>Bouleau</translation>
    </message>
    <message>
        <source>Apple</source>
        <translation>Pommier</translation>
    </message>
    <message>
        <source>Aspen</source>
        <translation>Tremble</translation>
    </message>
    <message>
        <source>Hazel</source>
        <translation>Noisetier</translation>
    </message>
    <message>
        <source>Linden</source>
        <translation>Tilleul</translation>
    </message>
    <message>
        <source>Redbud</source>
        <translation>Arbre de Judée</translation>
    </message>
    <message>
        <source>Willow</source>
        <translation>Saule</translation>
    </message>
    <message>
        <source>Olive</source>
        <translation>Olivier</translation>
    </message>
    <message>
        <source>Eucalyptus</source>
        <translation>Eucalyptus</translation>
    </message>
    <message>
        <source>Bamboo</source>
        <translation>Bambou</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>Graminée</translation>
    </message>
    <message>
        <source>Maple</source>
        <translation>Érable</translation>
    </message>
    <message>
        <source>Japanese maple</source>
        <translation>Érable du Japon</translation>
    </message>
    <message>
        <source>Plane tree</source>
        <translation>Platane</translation>
    </message>
    <message>
        <source>Sweetgum</source>
        <translation>Copalme</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>Chêne</translation>
    </message>
    <message>
        <source>Red oak</source>
        <translation>Chêne rouge</translation>
    </message>
    <message>
        <source>Hawthorn</source>
        <translation>Aubépine</translation>
    </message>
    <message>
        <source>Ginkgo</source>
        <translation>Ginkgo</translation>
    </message>
    <message>
        <source>Fan palm</source>
        <translation>Palmier éventail</translation>
    </message>
    <message>
        <source>Ash</source>
        <translation>Frêne</translation>
    </message>
    <message>
        <source>Rowan</source>
        <translation>Sorbier</translation>
    </message>
    <message>
        <source>Walnut</source>
        <translation>Noyer</translation>
    </message>
    <message>
        <source>Robinia</source>
        <translation>Robinier</translation>
    </message>
    <message>
        <source>Mimosa</source>
        <translation>Mimosa</translation>
    </message>
    <message>
        <source>Horse chestnut</source>
        <translation>Marronnier</translation>
    </message>
    <message>
        <source>Laburnum</source>
        <translation>Cytise</translation>
    </message>
    <message>
        <source>Fern</source>
        <translation>Fougère</translation>
    </message>
    <message>
        <source>Palm</source>
        <translation>Palmier</translation>
    </message>
    <message>
        <source>Yew</source>
        <translation>If</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Sapin</translation>
    </message>
    <message>
        <source>Scots pine</source>
        <translation>Pin sylvestre</translation>
    </message>
    <message>
        <source>White pine</source>
        <translation>Pin blanc</translation>
    </message>
    <message>
        <source>Larch</source>
        <translation>Mélèze</translation>
    </message>
    <message>
        <source>Cypress</source>
        <translation>Cyprès</translation>
    </message>
    <message>
        <source>As the plant</source>
        <translation>Comme la plante</translation>
    </message>
    <message>
        <source>Alternate</source>
        <translation>Alternes</translation>
    </message>
    <message>
        <source>In two rows</source>
        <translation>Sur deux rangs</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>En spirale</translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation>Opposées</translation>
    </message>
    <message>
        <source>Crossed pairs</source>
        <translation>Paires croisées</translation>
    </message>
    <message>
        <source>Whorled</source>
        <translation>Verticillées</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>The plant whose leaves the twigs carry, each on its petiole. Faithful: flat triangles that float about the twigs, squares in the rough model.</source>
        <translation>La plante dont les rameaux portent les feuilles, chacune sur son pétiole. Fidèle&#xa0;: des triangles plats qui flottent autour des rameaux, des carrés dans le modèle grossier.</translation>
    </message>
    <message>
        <source>Internode</source>
        <translation>Entre-nœud</translation>
    </message>
    <message>
        <source>How far it is along a twig from one node with leaves to the next: 1 as the plant has it.</source>
        <translation>Distance le long d’un rameau d’un nœud portant des feuilles au suivant&#xa0;: 1 comme la plante.</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>How the leaves of a twig follow each other. Alternate: one a node, two fifths of a turn apart; in two rows: left and right; spiral: 137.5° apart; opposite: pairs in one plane; crossed pairs: each across the last; whorled: several a node.</source>
        <translation>Comment les feuilles d’un rameau se suivent. Alternes&#xa0;: une par nœud, à deux cinquièmes de tour&#xa0;; sur deux rangs&#xa0;: à gauche et à droite&#xa0;; en spirale&#xa0;: tous les 137,5°&#xa0;; opposées&#xa0;: des paires dans un même plan&#xa0;; paires croisées&#xa0;: chacune en travers de la précédente&#xa0;; verticillées&#xa0;: plusieurs par nœud.</translation>
    </message>
    <message>
        <source>Leaves per node</source>
        <translation>Feuilles par nœud</translation>
    </message>
    <message>
        <source>How many leaves of a whorl stand around the twig.</source>
        <translation>Combien de feuilles d’un verticille entourent le rameau.</translation>
    </message>
    <message>
        <source>Angle to the twig</source>
        <translation>Angle avec le rameau</translation>
    </message>
    <message>
        <source>Between the twig and a petiole before it droops: 0 lies along the twig, a quarter turn stands away.</source>
        <translation>Entre le rameau et un pétiole avant qu’il ne retombe&#xa0;: 0 le couche le long du rameau, un quart de tour l’en écarte.</translation>
    </message>
    <message>
        <source>Droop</source>
        <translation>Retombée</translation>
    </message>
    <message>
        <source>How far the weight of a leaf pulls it down: 0 keeps the angle to the twig, 1 lets it hang.</source>
        <translation>De combien le poids d’une feuille la tire vers le bas&#xa0;: 0 garde l’angle avec le rameau, 1 la laisse pendre.</translation>
    </message>
    <message>
        <source>To the light</source>
        <translation>Vers la lumière</translation>
    </message>
    <message>
        <source>How far a petiole twists to turn the upper side of its leaf to the sky: 0 not at all, 1 as far as it goes.</source>
        <translation>De combien un pétiole se tord pour tourner le dessus de sa feuille vers le ciel&#xa0;: 0 pas du tout, 1 autant qu’il peut.</translation>
    </message>
    <message>
        <source>Leaf size</source>
        <translation>Taille des feuilles</translation>
    </message>
    <message>
        <source>Size varies</source>
        <translation>Variation de taille</translation>
    </message>
    <message>
        <source>How far one leaf may be larger or smaller than the others.</source>
        <translation>De combien une feuille peut être plus grande ou plus petite que les autres.</translation>
    </message>
    <message>
        <source>Leaf width</source>
        <translation>Largeur des feuilles</translation>
    </message>
    <message>
        <source>1 as the plant has it, more makes broader leaves. Leaflets end where their neighbours begin.</source>
        <translation>1 comme la plante, plus élargit les feuilles. Les folioles s’arrêtent où commencent leurs voisines.</translation>
    </message>
    <message>
        <source>Petiole</source>
        <translation>Pétiole</translation>
    </message>
    <message>
        <source>Length of the stalk between bark and blade: 1 as the plant has it, 0 none.</source>
        <translation>Longueur de la tige entre l’écorce et le limbe&#xa0;: 1 comme la plante, 0 aucune.</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Pli</translation>
    </message>
    <message>
        <source>How far both halves of a blade rise from its midrib.</source>
        <translation>De combien les deux moitiés du limbe se relèvent depuis sa nervure.</translation>
    </message>
    <message>
        <source>Curl</source>
        <translation>Enroulement</translation>
    </message>
    <message>
        <source>How far a blade bends down from its foot to its tip. Negative values bend it up.</source>
        <translation>De combien une lame se courbe vers le bas de son pied à sa pointe. Une valeur négative la courbe vers le haut.</translation>
    </message>
    <message>
        <source>Cup</source>
        <translation>Creux</translation>
    </message>
    <message>
        <source>1 hollows a blade like a spoon, -1 arches it, 0 leaves its halves even.</source>
        <translation>1 creuse un limbe comme une cuillère, -1 le bombe, 0 laisse ses moitiés droites.</translation>
    </message>
    <message>
        <source>Leaf detail</source>
        <translation>Détail des feuilles</translation>
    </message>
    <message>
        <source>1 draws a leaf with the fewest triangles, 3 with the smoothest outline.</source>
        <translation>1 dessine une feuille avec le moins de triangles, 3 avec le contour le plus fin.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Unie</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Écorce</translation>
    </message>
    <message>
        <source>Kind of bark. The program makes its picture, which repeats without a seam.</source>
        <translation>Genre d’écorce. Le programme fait son image, qui se répète sans couture.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>How deep cracks and furrows look: 1 as is usual for this bark, 0 flat.</source>
        <translation>La profondeur apparente des fentes et des sillons : 1 comme d’habitude pour cette écorce, 0 plate.</translation>
    </message>
    <message>
        <source>Lighter</source>
        <translation>Plus claire</translation>
    </message>
    <message>
        <source>Makes the bark lighter. Negative values make it darker.</source>
        <translation>Éclaircit l’écorce. Une valeur négative l’assombrit.</translation>
    </message>
    <message>
        <source>Moss</source>
        <translation>Mousse</translation>
    </message>
    <message>
        <source>How much of the bark moss covers. It begins in the cracks.</source>
        <translation>La part de l’écorce que la mousse couvre. Elle commence dans les fentes.</translation>
    </message>
    <message>
        <source>Seed of the bark</source>
        <translation>Graine de l’écorce</translation>
    </message>
    <message>
        <source>Another seed draws another piece of the same bark.</source>
        <translation>Une autre graine dessine un autre morceau de la même écorce.</translation>
    </message>
    <message>
        <source>Side of the piece of bark that is repeated, on the thickest wood. It is smaller on thinner wood, and a whole number of them goes around every branch. 0: four go around the trunk.</source>
        <translation>Le côté du morceau d’écorce qui se répète, sur le bois le plus épais. Il est plus petit sur le bois plus fin, et un nombre entier en fait le tour de chaque branche. 0 : quatre font le tour du tronc.</translation>
    </message>
    <message>
        <source>A map of bark has %1 to %2 pixels a side</source>
        <translation>Une image d’écorce a de %1 à %2 pixels de côté</translation>
    </message>
    <message>
        <source>Plain bark has no maps</source>
        <translation>Une écorce unie n’a pas d’images</translation>
    </message>
    <message>
        <source>Pine</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Spruce</source>
        <translation>Épicéa</translation>
    </message>
    <message>
        <source>Cedar</source>
        <translation>Cèdre</translation>
    </message>
    <message>
        <source>Kapok</source>
        <translation>Kapokier</translation>
    </message>
    <message>
        <source>Cork oak</source>
        <translation>Chêne-liège</translation>
    </message>
    <message>
        <source>the picture could not be made: %1</source>
        <translation>l’image n’a pas pu être faite : %1</translation>
    </message>
    <message>
        <source>Fruit</source>
        <translation>Fruit</translation>
    </message>
    <message>
        <source>Fruit or flowers on the twigs: fruit hang on their stalks, blossom faces the light. Faithful: a sphere about the twig, a cube in the rough model.</source>
        <translation>Fruits ou fleurs sur les rameaux : les fruits pendent à leur queue, les fleurs se tournent vers la lumière. Fidèle : une sphère autour du rameau, un cube dans le modèle grossier.</translation>
    </message>
    <message>
        <source>Fruit size</source>
        <translation>Taille des fruits</translation>
    </message>
    <message>
        <source>Fruit stalk</source>
        <translation>Queue des fruits</translation>
    </message>
    <message>
        <source>Length of the stalk: 1 as the plant has it, 0 none.</source>
        <translation>Longueur de la queue : 1 comme la plante, 0 aucune.</translation>
    </message>
    <message>
        <source>Pear</source>
        <translation>Poire</translation>
    </message>
    <message>
        <source>Cherries</source>
        <translation>Cerises</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>Prune</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation>Citron</translation>
    </message>
    <message>
        <source>Olives</source>
        <translation>Olives</translation>
    </message>
    <message>
        <source>Acorns</source>
        <translation>Glands</translation>
    </message>
    <message>
        <source>Coconuts</source>
        <translation>Noix de coco</translation>
    </message>
    <message>
        <source>Berries</source>
        <translation>Baies</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Fleurs</translation>
    </message>
    <message>
        <source>Petiole stiffness</source>
        <translation>Raideur des pétioles</translation>
    </message>
    <message>
        <source>How firmly a petiole holds its leaf against wind and weight: less lets leaves swing far and slowly.</source>
        <translation>Avec quelle fermeté un pétiole tient sa feuille contre le vent et le poids&#xa0;: moins laisse les feuilles se balancer loin et lentement.</translation>
    </message>
    <message>
        <source>Flutter</source>
        <translation>Frémissement</translation>
    </message>
    <message>
        <source>How much leaves tremble in the wind: 1 as usual, 0 not at all.</source>
        <translation>Combien les feuilles tremblent dans le vent&#xa0;: 1 comme d’habitude, 0 pas du tout.</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Saison</translation>
    </message>
    <message>
        <source>the faithful leaf has no picture</source>
        <translation>la feuille fidèle n&apos;a pas d&apos;image</translation>
    </message>
    <message>
        <source>a picture of %1 pixels: %2 to %3 are possible</source>
        <translation>une image de %1 pixels : %2 à %3 sont possibles</translation>
    </message>
    <message>
        <source>the place of one of %1 is not a finite number</source>
        <translation>la place d’un des éléments de %1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>the picture is missing or cannot be read</source>
        <translation>l’image est introuvable ou illisible</translation>
    </message>
    <message>
        <source>Colour picture</source>
        <translation>Image de couleur</translation>
    </message>
    <message>
        <source>An image file (PNG or JPEG) that is the colour of the surface.</source>
        <translation>Un fichier d’image (PNG ou JPEG) qui donne la couleur de la surface.</translation>
    </message>
    <message>
        <source>Normal picture</source>
        <translation>Image de normales</translation>
    </message>
    <message>
        <source>An image file of the directions in which the surface looks (OpenGL&apos;s way: green points up).</source>
        <translation>Un fichier d’image des directions vers lesquelles la surface regarde (à la manière d’OpenGL : le vert pointe vers le haut).</translation>
    </message>
    <message>
        <source>Roughness picture</source>
        <translation>Image de rugosité</translation>
    </message>
    <message>
        <source>An image file that says how dull the surface is: white has no highlights.</source>
        <translation>Un fichier d’image qui dit à quel point la surface est mate : le blanc n’a pas de reflets.</translation>
    </message>
    <message>
        <source>Height picture</source>
        <translation>Image de relief</translation>
    </message>
    <message>
        <source>An image file with the height of the surface: white is highest. If there is no picture of normals, they are computed from it.</source>
        <translation>Un fichier d’image qui donne la hauteur de la surface : le blanc est le plus haut. Sans image de normales, elles en sont calculées.</translation>
    </message>
    <message>
        <source>Occlusion picture</source>
        <translation>Image d’occlusion</translation>
    </message>
    <message>
        <source>An image file that says where little light gets to: black is the depth of a crack.</source>
        <translation>Un fichier d’image qui dit où peu de lumière arrive : le noir est le fond d’une fissure.</translation>
    </message>
    <message>
        <source>Opacity picture</source>
        <translation>Image d’opacité</translation>
    </message>
    <message>
        <source>An image file that cuts the surface out: black parts are invisible.</source>
        <translation>Un fichier d’image qui découpe la surface : les parties noires sont invisibles.</translation>
    </message>
    <message>
        <source>Pictures of the bark</source>
        <translation>Images de l’écorce</translation>
    </message>
    <message>
        <source>Pictures of the leaves</source>
        <translation>Images des feuilles</translation>
    </message>
    <message>
        <source>Pictures of the fruit</source>
        <translation>Images des fruits</translation>
    </message>
    <message>
        <source>Pictures of the surface</source>
        <translation>Images de la surface</translation>
    </message>
    <message>
        <source>the picture is missing</source>
        <translation>l’image est introuvable</translation>
    </message>
    <message>
        <source>this is no file</source>
        <translation>ce n’est pas un fichier</translation>
    </message>
    <message>
        <source>this is neither a PNG nor a JPEG picture</source>
        <translation>ce n’est une image ni PNG ni JPEG</translation>
    </message>
    <message>
        <source>the picture is broken: %1</source>
        <translation>l’image est abîmée : %1</translation>
    </message>
    <message>
        <source>the picture has %1 × %2 pixels: at most %3 a side</source>
        <translation>l’image a %1 × %2 pixels : %3 de côté au plus</translation>
    </message>
    <message>
        <source>iteration %1 would make more than %2 modules</source>
        <translation>l’itération %1 donnerait plus de %2 modules</translation>
    </message>
    <message>
        <source>this is not a finite number for %1 in iteration %2</source>
        <translation>ce n’est pas un nombre fini pour %1 à l’itération %2</translation>
    </message>
    <message>
        <source>the result is not a finite number</source>
        <translation>le résultat n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>a number, a name or &quot;(&quot; is expected here</source>
        <translation>un nombre, un nom ou «&#xa0;(&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a parameter of this rule&apos;s modules nor a constant nor a function</source>
        <translation>«&#xa0;%1&#xa0;» n’est ni un paramètre des modules de cette règle, ni une constante, ni une fonction</translation>
    </message>
    <message>
        <source>&quot;(&quot; is expected here: this is a function</source>
        <translation>«&#xa0;(&#xa0;» est attendu ici : c’est une fonction</translation>
    </message>
    <message>
        <source>one number is expected in these brackets, not %1</source>
        <translation>un nombre est attendu entre ces parenthèses, et non %1</translation>
    </message>
    <message>
        <source>two numbers are expected in these brackets, not %1</source>
        <translation>deux nombres sont attendus entre ces parenthèses, et non %1</translation>
    </message>
    <message>
        <source>&quot;)&quot; is expected here</source>
        <translation>«&#xa0;)&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>the expression is nested deeper than %1</source>
        <translation>l’expression est imbriquée à plus de %1 niveaux</translation>
    </message>
    <message>
        <source>brackets are nested too deep here</source>
        <translation>les crochets sont imbriqués trop profondément ici</translation>
    </message>
    <message>
        <source>%1 asks for a diameter below 0, or beyond all measure</source>
        <translation>%1 demande un diamètre inférieur à 0, ou démesuré</translation>
    </message>
    <message>
        <source>%1 asks for a length below 0</source>
        <translation>%1 demande une longueur inférieure à 0</translation>
    </message>
    <message>
        <source>at %1 the tree is larger than 10^6 km</source>
        <translation>à %1, l’arbre dépasse 10^6 km</translation>
    </message>
    <message>
        <source>a name is expected here</source>
        <translation>un nom est attendu ici</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a meaning of its own already</source>
        <translation>«&#xa0;%1&#xa0;» a déjà un sens dans le langage</translation>
    </message>
    <message>
        <source>there is a constant &quot;%1&quot; already</source>
        <translation>il y a déjà une constante «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;=&quot; is expected here</source>
        <translation>«&#xa0;=&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>an operator or the end of the line is expected here</source>
        <translation>un opérateur ou la fin de la ligne est attendu ici</translation>
    </message>
    <message>
        <source>&quot;-&gt;&quot;, &quot;:&quot;, &quot;&lt;&quot; or &quot;&gt;&quot; is expected here: a module or a context is one letter, and its names stand in brackets</source>
        <translation>«&#xa0;-&gt;&#xa0;», «&#xa0;:&#xa0;», «&#xa0;&lt;&#xa0;» ou «&#xa0;&gt;&#xa0;» est attendu ici : un module ou un contexte est une seule lettre, et ses noms sont entre parenthèses</translation>
    </message>
    <message>
        <source>an operator or &quot;-&gt;&quot; is expected here</source>
        <translation>un opérateur ou «&#xa0;-&gt;&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>the rule has two parameters &quot;%1&quot;</source>
        <translation>la règle a deux paramètres «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>brackets are neither replaced nor a context</source>
        <translation>les crochets ne sont ni remplacés ni un contexte</translation>
    </message>
    <message>
        <source>&quot;,&quot; or &quot;)&quot; is expected here</source>
        <translation>«&#xa0;,&#xa0;» ou «&#xa0;)&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>a module has at most %1 numbers</source>
        <translation>un module a au plus %1 nombres</translation>
    </message>
    <message>
        <source>each outcome needs a weight and a colon: &quot;0.5: F&quot;</source>
        <translation>chaque issue demande un poids et un deux-points : «&#xa0;0.5: F&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;:&quot; is expected here</source>
        <translation>«&#xa0;:&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>the weights must add up to more than 0, and to a finite number</source>
        <translation>la somme des poids doit être supérieure à 0 et finie</translation>
    </message>
    <message>
        <source>axiom and rules have more than %1 modules</source>
        <translation>l’axiome et les règles ont plus de %1 modules</translation>
    </message>
    <message>
        <source>an operator, &quot;,&quot; or &quot;)&quot; is expected here</source>
        <translation>un opérateur, «&#xa0;,&#xa0;» ou «&#xa0;)&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langage</translation>
    </message>
    <message>
        <source>Letters: each symbol is one letter, and every step has one length. Modules with numbers: letters carry lengths, widths and angles, and rules compute with them.</source>
        <translation>Lettres : chaque symbole est une lettre, et tous les pas ont la même longueur. Modules avec nombres : les lettres portent des longueurs, des largeurs et des angles, et les règles calculent avec eux.</translation>
    </message>
    <message>
        <source>Constants</source>
        <translation>Constantes</translation>
    </message>
    <message>
        <source>Names for numbers that axiom and rules use, one a line: &quot;r1 = 0.9&quot;. A line may use the names above it.</source>
        <translation>Des noms pour les nombres de l’axiome et des règles, un par ligne : «&#xa0;r1 = 0.9&#xa0;». Une ligne peut employer les noms qui la précèdent.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Tropisme</translation>
    </message>
    <message>
        <source>Direction that branches bend towards as they grow: down under their weight, up towards the light. A longer arrow bends them more.</source>
        <translation>Direction vers laquelle les branches se courbent en poussant : vers le bas sous leur poids, vers le haut pour la lumière. Une flèche plus longue les courbe davantage.</translation>
    </message>
    <message>
        <source>Elasticity</source>
        <translation>Élasticité</translation>
    </message>
    <message>
        <source>How much each piece of branch gives way to the tropism. 0: branches stay as the rules say.</source>
        <translation>À quel point chaque morceau de branche cède au tropisme. 0 : les branches restent comme le disent les règles.</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Lettres</translation>
    </message>
    <message>
        <source>Modules with numbers</source>
        <translation>Modules avec nombres</translation>
    </message>
    <message>
        <source>A trunk that goes on to the top, with boughs around it</source>
        <translation>Un tronc qui monte jusqu’à la cime, entouré de branches</translation>
    </message>
    <message>
        <source>An umbrella: every branch ends in two, and these lie level</source>
        <translation>Un parasol : chaque branche finit en deux autres, de niveau</translation>
    </message>
    <message>
        <source>Long twigs that bend down under their weight</source>
        <translation>De longs rameaux qui plient sous leur poids</translation>
    </message>
    <message>
        <source>the trunk has no length</source>
        <translation>le tronc n’a pas de longueur</translation>
    </message>
    <message>
        <source>the stems have more pieces than the limit of %1</source>
        <translation>les tiges ont plus de morceaux que la limite de %1</translation>
    </message>
    <message>
        <source>Weber and Penn</source>
        <translation>Weber et Penn</translation>
    </message>
    <message>
        <source>Conical</source>
        <translation>Conique</translation>
    </message>
    <message>
        <source>Spherical</source>
        <translation>Sphérique</translation>
    </message>
    <message>
        <source>Hemispherical</source>
        <translation>Hémisphérique</translation>
    </message>
    <message>
        <source>Cylindrical</source>
        <translation>Cylindrique</translation>
    </message>
    <message>
        <source>Tapered cylinder</source>
        <translation>Cylindre effilé</translation>
    </message>
    <message>
        <source>Flame</source>
        <translation>Flamme</translation>
    </message>
    <message>
        <source>Inverse cone</source>
        <translation>Cône renversé</translation>
    </message>
    <message>
        <source>Nearly a flame</source>
        <translation>Presque une flamme</translation>
    </message>
    <message>
        <source>Pruning envelope</source>
        <translation>Enveloppe de taille</translation>
    </message>
    <message>
        <source>Generator</source>
        <translation>Générateur</translation>
    </message>
    <message>
        <source>The Algorithmic Beauty of Plants</source>
        <translation>The Algorithmic Beauty of Plants</translation>
    </message>
    <message>
        <source>Conifers</source>
        <translation>Conifères</translation>
    </message>
    <message>
        <source>Broadleaved trees</source>
        <translation>Feuillus</translation>
    </message>
    <message>
        <source>Slender, with a light crown that never rests</source>
        <translation>Élancé, avec une cime légère qui ne se repose jamais</translation>
    </message>
    <message>
        <source>A straight trunk through a narrow cone of level limbs</source>
        <translation>Un tronc droit dans un cône étroit de branches horizontales</translation>
    </message>
    <message>
        <source>A short trunk below curtains of hanging shoots</source>
        <translation>Un tronc court sous des rideaux de pousses pendantes</translation>
    </message>
    <message>
        <source>Low and wide, with crooked limbs from the ground on</source>
        <translation>Bas et large, avec des branches tortueuses dès le sol</translation>
    </message>
    <message>
        <source>Level 0: trunk</source>
        <translation>Niveau 0 : tronc</translation>
    </message>
    <message>
        <source>Level 1: limbs</source>
        <translation>Niveau 1 : charpentières</translation>
    </message>
    <message>
        <source>Level 2: branches</source>
        <translation>Niveau 2 : branches</translation>
    </message>
    <message>
        <source>Level 3: twigs</source>
        <translation>Niveau 3 : rameaux</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Cime</translation>
    </message>
    <message>
        <source>How long limbs are by their height on the trunk: the outline of the crown.</source>
        <translation>La longueur des charpentières selon leur hauteur sur le tronc : le contour de la cime.</translation>
    </message>
    <message>
        <source>Size of the tree; the length of the trunk is a share of it.</source>
        <translation>Taille de l’arbre ; la longueur du tronc en est une part.</translation>
    </message>
    <message>
        <source>Height varies</source>
        <translation>Variation de la hauteur</translation>
    </message>
    <message>
        <source>How far the height of one tree may lie from it, by seed.</source>
        <translation>De combien la hauteur d’un arbre peut s’en écarter, selon la graine.</translation>
    </message>
    <message>
        <source>Bare trunk</source>
        <translation>Tronc nu</translation>
    </message>
    <message>
        <source>The share of the trunk, from the ground, without limbs.</source>
        <translation>La part du tronc, depuis le sol, sans charpentières.</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>1: a trunk alone; 2: with limbs; 3: with branches; 4: with twigs.</source>
        <translation>1 : un tronc seul ; 2 : avec charpentières ; 3 : avec branches ; 4 : avec rameaux.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Radius of the trunk as a share of its length. Leaves and fruit take their size from it too.</source>
        <translation>Rayon du tronc comme part de sa longueur. Feuilles et fruits en tirent aussi leur taille.</translation>
    </message>
    <message>
        <source>Thinner branches</source>
        <translation>Branches plus minces</translation>
    </message>
    <message>
        <source>How much thinner a shorter stem is than the one that carries it: the radii are as this power of the lengths.</source>
        <translation>De combien une tige plus courte est plus mince que celle qui la porte : les rayons sont comme cette puissance des longueurs.</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Empattement</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Lobes</translation>
    </message>
    <message>
        <source>Ribs around the trunk. Cross-sections here are round: they get the radius that the ribs have on average.</source>
        <translation>Côtes autour du tronc. Ici les sections sont rondes : elles prennent le rayon moyen des côtes.</translation>
    </message>
    <message>
        <source>Depth of lobes</source>
        <translation>Profondeur des lobes</translation>
    </message>
    <message>
        <source>How far the ribs stand out, as a share of the trunk&apos;s radius.</source>
        <translation>De combien les côtes ressortent, comme part du rayon du tronc.</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>How strongly branches from the second level on grow towards the sky; negative, towards the ground.</source>
        <translation>La force avec laquelle les branches, dès le deuxième niveau, poussent vers le ciel ; négative, vers le sol.</translation>
    </message>
    <message>
        <source>Pruning</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>How far limbs that reach out of the pruning envelope are shortened to fit: 0 not at all, 1 fully.</source>
        <translation>De combien les charpentières qui sortent de l’enveloppe de taille sont raccourcies pour y tenir : 0 pas du tout, 1 entièrement.</translation>
    </message>
    <message>
        <source>Envelope width</source>
        <translation>Largeur de l’enveloppe</translation>
    </message>
    <message>
        <source>Half the greatest width of the pruning envelope, as a share of the height.</source>
        <translation>La moitié de la plus grande largeur de l’enveloppe de taille, comme part de la hauteur.</translation>
    </message>
    <message>
        <source>Widest at</source>
        <translation>Plus large à</translation>
    </message>
    <message>
        <source>Height at which the envelope is widest: 0 at the base of the crown, 1 at its top.</source>
        <translation>Hauteur à laquelle l’enveloppe est la plus large : 0 à la base de la cime, 1 au sommet.</translation>
    </message>
    <message>
        <source>Curve below</source>
        <translation>Courbe du bas</translation>
    </message>
    <message>
        <source>The outline below the widest place: 1 straight, less full, more hollow.</source>
        <translation>Le contour sous l’endroit le plus large : 1 droit, moins bombé, plus creux.</translation>
    </message>
    <message>
        <source>Curve above</source>
        <translation>Courbe du haut</translation>
    </message>
    <message>
        <source>The outline above the widest place: 1 straight, less full, more hollow.</source>
        <translation>Le contour au-dessus de l’endroit le plus large : 1 droit, moins bombé, plus creux.</translation>
    </message>
    <message>
        <source>Stems</source>
        <translation>Tiges</translation>
    </message>
    <message>
        <source>How many stems of this level a full stem of the level below carries; at level 0, how many trunks share the foot.</source>
        <translation>Combien de tiges de ce niveau porte une tige entière du niveau inférieur ; au niveau 0, combien de troncs partagent le pied.</translation>
    </message>
    <message>
        <source>Length as a share of the parent stem&apos;s. For the trunk, a share of the tree&apos;s height.</source>
        <translation>Longueur comme part de la tige qui la porte. Pour le tronc, part de la hauteur de l’arbre.</translation>
    </message>
    <message>
        <source>Length varies</source>
        <translation>Variation de la longueur</translation>
    </message>
    <message>
        <source>How far that share may be more or less, by seed.</source>
        <translation>De combien cette part peut être plus grande ou plus petite, selon la graine.</translation>
    </message>
    <message>
        <source>0: a cylinder; 1: a cone to a point; 2: a cylinder with a round end; 3: a chain of spheres. Between them, a mixture.</source>
        <translation>0 : un cylindre ; 1 : un cône pointu ; 2 : un cylindre à bout rond ; 3 : une chaîne de sphères. Entre eux, un mélange.</translation>
    </message>
    <message>
        <source>Angle to the parent</source>
        <translation>Angle au parent</translation>
    </message>
    <message>
        <source>Angle varies</source>
        <translation>Variation de l’angle</translation>
    </message>
    <message>
        <source>How far that angle may be more or less. Negative: not by chance but by height, more at the lowest stem, less at the highest.</source>
        <translation>De combien cet angle peut être plus grand ou plus petit. Négatif : non par hasard mais selon la hauteur, plus grand pour la tige la plus basse, plus petit pour la plus haute.</translation>
    </message>
    <message>
        <source>Turn around</source>
        <translation>Rotation autour</translation>
    </message>
    <message>
        <source>From one stem to the next around the one that carries them. Negative: left and right in turns.</source>
        <translation>D’une tige à la suivante autour de celle qui les porte. Négatif : à gauche et à droite tour à tour.</translation>
    </message>
    <message>
        <source>Turn varies</source>
        <translation>Variation de la rotation</translation>
    </message>
    <message>
        <source>How far each of these turns may be more or less, by seed.</source>
        <translation>De combien chacune de ces rotations peut être plus grande ou plus petite, selon la graine.</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>How many pieces a stem bends in.</source>
        <translation>En combien de morceaux une tige se courbe.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>Angle by which a stem bends from its foot to its tip, away from its parent. A negative angle bends it towards the parent.</source>
        <translation>Angle dont une tige se courbe de son pied à sa pointe, à l’écart de celle qui la porte. Un angle négatif la courbe vers elle.</translation>
    </message>
    <message>
        <source>Curve back</source>
        <translation>Courbure en retour</translation>
    </message>
    <message>
        <source>If it is not 0, the first half of a stem bends by the curve, the second half by this angle.</source>
        <translation>Si ce n’est pas 0, la première moitié d’une tige suit la courbure, la seconde cet angle.</translation>
    </message>
    <message>
        <source>Curve varies</source>
        <translation>Variation de la courbure</translation>
    </message>
    <message>
        <source>How crooked a stem is, by seed. Negative: it winds in a helix of this angle.</source>
        <translation>À quel point une tige est tortueuse, selon la graine. Négatif : elle s’enroule en hélice de cet angle.</translation>
    </message>
    <message>
        <source>Splits at the foot</source>
        <translation>Divisions au pied</translation>
    </message>
    <message>
        <source>Into how many stems more it splits at the end of its first piece.</source>
        <translation>En combien de tiges de plus elle se divise au bout de son premier morceau.</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>Divisions</translation>
    </message>
    <message>
        <source>Into how many stems more it splits at the end of each other piece, on average.</source>
        <translation>En combien de tiges de plus elle se divise au bout de chaque autre morceau, en moyenne.</translation>
    </message>
    <message>
        <source>Split angle</source>
        <translation>Angle de division</translation>
    </message>
    <message>
        <source>How far the stems of a split turn away from each other. Leaning stems turn less.</source>
        <translation>De combien les tiges d’une fourche s’écartent l’une de l’autre. Les tiges penchées s’écartent moins.</translation>
    </message>
    <message>
        <source>Split angle varies</source>
        <translation>Variation de l’angle de division</translation>
    </message>
    <message>
        <source>How far that angle may be more or less, by seed.</source>
        <translation>De combien cet angle peut être plus grand ou plus petit, selon la graine.</translation>
    </message>
    <message>
        <source>A white trunk, and fine twigs that hang from rising limbs</source>
        <translation>Un tronc blanc, et de fins rameaux qui pendent de branches montantes</translation>
    </message>
    <message>
        <source>A narrow column: all limbs rise close to the trunk</source>
        <translation>Une colonne étroite : toutes les branches montent près du tronc</translation>
    </message>
    <message>
        <source>A stout trunk that parts into a broad round crown</source>
        <translation>Un tronc robuste qui s’ouvre en une large cime ronde</translation>
    </message>
    <message>
        <source>A dark spire of limbs that droop and rise again</source>
        <translation>Une flèche sombre de branches qui retombent et se relèvent</translation>
    </message>
    <message>
        <source>A tall bare trunk below an open crown of tufts</source>
        <translation>Un long tronc nu sous une cime ouverte de touffes</translation>
    </message>
    <message>
        <source>the branches have more pieces than the limit of %1</source>
        <translation>les branches ont plus de morceaux que la limite de %1</translation>
    </message>
    <message>
        <source>no point of the crown comes within sight of the trunk</source>
        <translation>aucun point du houppier n’est à portée de vue du tronc</translation>
    </message>
    <message>
        <source>the crown is too wide for its height: its shadows need more than %1 voxels</source>
        <translation>le houppier est trop large pour sa hauteur : ses ombres demandent plus de %1 voxels</translation>
    </message>
    <message>
        <source>the crown&apos;s shadows need more than %1 voxels</source>
        <translation>les ombres du houppier demandent plus de %1 voxels</translation>
    </message>
    <message>
        <source>the tree bears more pieces than the limit of %1</source>
        <translation>l’arbre porte plus de morceaux que la limite de %1</translation>
    </message>
    <message>
        <source>a number was expected here</source>
        <translation>un nombre était attendu ici</translation>
    </message>
    <message>
        <source>heights and radii of a profile are shares from 0 to 1</source>
        <translation>les hauteurs et les rayons d’un profil sont des parts de 0 à 1</translation>
    </message>
    <message>
        <source>each height must be greater than the one before</source>
        <translation>chaque hauteur doit être supérieure à la précédente</translation>
    </message>
    <message>
        <source>a profile has at most %1 pairs</source>
        <translation>un profil a au plus %1 paires</translation>
    </message>
    <message>
        <source>a comma was expected between two pairs</source>
        <translation>une virgule était attendue entre deux paires</translation>
    </message>
    <message>
        <source>a profile needs two pairs or more</source>
        <translation>un profil demande au moins deux paires</translation>
    </message>
    <message>
        <source>a profile must be wider than nothing somewhere</source>
        <translation>un profil doit avoir une largeur quelque part</translation>
    </message>
    <message>
        <source>Space colonisation</source>
        <translation>Par colonisation</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Enveloppe</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>The outline of the crown: pairs of height and radius, as shares of the crown&apos;s, &quot;0 0.3, 0.5 1, 1 0&quot;. A smooth curve goes through them.</source>
        <translation>Le contour du houppier : des paires hauteur et rayon, en parts de ceux du houppier, &quot;0 0.3, 0.5 1, 1 0&quot;. Une courbe lisse passe par ces points.</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Commence à</translation>
    </message>
    <message>
        <source>How high above the ground the crown begins: the bare trunk.</source>
        <translation>À quelle hauteur du sol commence le houppier : le tronc nu.</translation>
    </message>
    <message>
        <source>Height of the crown</source>
        <translation>Hauteur du houppier</translation>
    </message>
    <message>
        <source>From where the crown begins to its top.</source>
        <translation>Du début du houppier à son sommet.</translation>
    </message>
    <message>
        <source>Radius of the crown</source>
        <translation>Rayon du houppier</translation>
    </message>
    <message>
        <source>Half the greatest width of the crown.</source>
        <translation>La moitié de la plus grande largeur de la couronne.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Places in the crown that branches grow to reach. More of them give finer and more crowded twigs.</source>
        <translation>Les endroits du houppier que les branches cherchent à atteindre. Davantage de points donnent des rameaux plus fins et plus serrés.</translation>
    </message>
    <message>
        <source>To the surface</source>
        <translation>Vers la surface</translation>
    </message>
    <message>
        <source>0 spreads the points through the whole crown, 1 lays them all on its surface, where the light is.</source>
        <translation>0 répartit les points dans tout le houppier, 1 les pose tous à sa surface, là où est la lumière.</translation>
    </message>
    <message>
        <source>Sight</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>How far a branch sees points. Far sight gives long calm limbs, short sight restless ones.</source>
        <translation>Jusqu’où une branche voit les points. Une vue longue donne de longues charpentières calmes, une vue courte des branches agitées.</translation>
    </message>
    <message>
        <source>Reached within</source>
        <translation>Atteint à moins de</translation>
    </message>
    <message>
        <source>A point so near to a branch is reached and draws nothing any more. Small values give dense twigs, large ones a sparse crown.</source>
        <translation>Un point si proche d’une branche est atteint et n’attire plus rien. De petites valeurs donnent des rameaux denses, de grandes un houppier clairsemé.</translation>
    </message>
    <message>
        <source>Growth at once</source>
        <translation>Pousse à la fois</translation>
    </message>
    <message>
        <source>Length of the piece that a branch grows before it looks for points again.</source>
        <translation>Longueur du morceau qu’une branche pousse avant de chercher de nouveau des points.</translation>
    </message>
    <message>
        <source>Direction that attracts branches in addition to the points: up to the light, or down. A longer arrow attracts more.</source>
        <translation>Direction qui attire les branches en plus des points : vers le haut, la lumière, ou vers le bas. Une flèche plus longue attire davantage.</translation>
    </message>
    <message>
        <source>Radii add as</source>
        <translation>Somme des rayons</translation>
    </message>
    <message>
        <source>At a fork, the branches&apos; radii to this power add up: 2 gives stout trunks, 3 slender ones.</source>
        <translation>À une fourche, les rayons des branches à cette puissance s’additionnent : 2 donne des troncs forts, 3 des troncs minces.</translation>
    </message>
    <message>
        <source>Radius of tips</source>
        <translation>Rayon des bouts</translation>
    </message>
    <message>
        <source>Radius of every twig at its end. All others follow from it.</source>
        <translation>Rayon de chaque rameau à son bout. Tous les autres en découlent.</translation>
    </message>
    <message>
        <source>Shortest twig</source>
        <translation>Rameau le plus court</translation>
    </message>
    <message>
        <source>Side twigs that end before this length are left out.</source>
        <translation>Les rameaux latéraux plus courts que cette longueur sont omis.</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>0 leaves every kink that growth made, 1 straightens them into curves.</source>
        <translation>0 laisse chaque coude de la croissance, 1 les adoucit en courbes.</translation>
    </message>
    <message>
        <source>Hemisphere</source>
        <translation>Demi-sphère</translation>
    </message>
    <message>
        <source>A round crown that its branches fill</source>
        <translation>Un houppier rond que ses branches remplissent</translation>
    </message>
    <message>
        <source>A flat roof of twigs, drawn as a profile</source>
        <translation>Un toit plat de rameaux, dessiné comme un profil</translation>
    </message>
    <message>
        <source>A dense oval crown on rising limbs</source>
        <translation>Un houppier ovale et dense sur des charpentières montantes</translation>
    </message>
    <message>
        <source>A small tree in layers, wide and low, with fine lobed leaves</source>
        <translation>Un petit arbre étagé, large et bas, aux feuilles finement lobées</translation>
    </message>
    <message>
        <source>A tall open dome, its limbs swept up at their ends</source>
        <translation>Un grand dôme ouvert, aux charpentières relevées à leur bout</translation>
    </message>
    <message>
        <source>A smooth grey column below a huge dense dome</source>
        <translation>Une colonne lisse et grise sous un vaste dôme dense</translation>
    </message>
    <message>
        <source>A dense tall egg, its lowest limbs hanging</source>
        <translation>Un haut œuf dense, aux branches basses tombantes</translation>
    </message>
    <message>
        <source>A heavy dome of great hands, each limb rising at its end</source>
        <translation>Un lourd dôme de grandes mains, chaque charpentière relevée à son bout</translation>
    </message>
    <message>
        <source>A straight stem with limbs in rings</source>
        <translation>Un fût droit aux charpentières en couronnes</translation>
    </message>
    <message>
        <source>A low round head of crooked limbs, hung with apples</source>
        <translation>Une tête basse et ronde de branches tortues, chargée de pommes</translation>
    </message>
    <message>
        <source>A gnarled short trunk under clouds of grey leaves</source>
        <translation>Un tronc court et noueux sous des nuages de feuilles grises</translation>
    </message>
    <message>
        <source>Stiff rising limbs close-set with fans</source>
        <translation>Des charpentières raides et montantes, garnies d’éventails</translation>
    </message>
    <message>
        <source>A great open dome on a patched trunk</source>
        <translation>Un grand dôme ouvert sur un tronc marbré</translation>
    </message>
    <message>
        <source>A vase: limbs part low and spread into a fountain</source>
        <translation>Un vase : les charpentières se séparent bas et s’ouvrent en fontaine</translation>
    </message>
    <message>
        <source>A tall silvery head on leaning limbs</source>
        <translation>Une haute tête argentée sur des charpentières penchées</translation>
    </message>
    <message>
        <source>A tall wide vase of stout limbs</source>
        <translation>Un haut vase large de fortes charpentières</translation>
    </message>
    <message>
        <source>A dark pyramid of leather leaves, clothed to the ground</source>
        <translation>Une pyramide sombre de feuilles coriaces, vêtue jusqu’au sol</translation>
    </message>
    <message>
        <source>A slight upright tree with feathered leaves and red berries</source>
        <translation>Un arbre frêle et dressé, aux feuilles pennées et aux baies rouges</translation>
    </message>
    <message>
        <source>An open airy crown of crooked limbs in tiers</source>
        <translation>Un houppier aéré de branches tortues étagées</translation>
    </message>
    <message>
        <source>A dense thorny small tree, red with haws</source>
        <translation>Un petit arbre dense et épineux, rouge de cenelles</translation>
    </message>
    <message>
        <source>A broad grey head of large feathered leaves</source>
        <translation>Une large tête grise de grandes feuilles pennées</translation>
    </message>
    <message>
        <source>A straight narrow pyramid of star leaves</source>
        <translation>Une pyramide droite et étroite de feuilles en étoile</translation>
    </message>
    <message>
        <source>A tall pale stem that sheds its bark, with hanging leaves</source>
        <translation>Un haut fût pâle qui perd son écorce, aux feuilles pendantes</translation>
    </message>
    <message>
        <source>A swollen trunk with roots for branches</source>
        <translation>Un tronc enflé, avec des racines pour branches</translation>
    </message>
    <message>
        <source>A slender open cone that is bare in winter</source>
        <translation>Un cône élancé et ouvert, nu en hiver</translation>
    </message>
    <message>
        <source>A very tall dense spire on a furrowed trunk</source>
        <translation>Une très haute flèche dense sur un tronc crevassé</translation>
    </message>
    <message>
        <source>An umbrella on a tall bare trunk</source>
        <translation>Un parasol sur un haut tronc nu</translation>
    </message>
    <message>
        <source>Wide level tables of dark needles, one above the other</source>
        <translation>De larges plateaux d’aiguilles sombres, l’un au-dessus de l’autre</translation>
    </message>
    <message>
        <source>A dark green flame, hardly wider than its trunk</source>
        <translation>Une flamme vert sombre, à peine plus large que son tronc</translation>
    </message>
    <message>
        <source>A massive flared column with a narrow crown of short limbs</source>
        <translation>Une colonne massive et évasée à l’étroit houppier de branches courtes</translation>
    </message>
    <message>
        <source>A broad dark dome, several stems from one foot</source>
        <translation>Un large dôme sombre, plusieurs tiges d’un même pied</translation>
    </message>
    <message>
        <source>Level whorled limbs with soft plumes of needles</source>
        <translation>Des branches verticillées et horizontales aux plumets d’aiguilles souples</translation>
    </message>
    <message>
        <source>A narrow regular spire, dense to the ground</source>
        <translation>Une flèche étroite et régulière, dense jusqu’au sol</translation>
    </message>
    <message>
        <source>there is no .obj of this name: a camera, as it is called one</source>
        <translation>il n’y a pas de .obj de ce nom : une caméra, puisqu’elle en porte le nom</translation>
    </message>
    <message>
        <source>Angle of view</source>
        <translation>Angle de vue</translation>
    </message>
    <message>
        <source>From the top of the picture to its bottom: a wide lens has a large one. 27° is a lens of 50 mm before a film of 24 mm.</source>
        <translation>Du haut de l’image à son bas : un grand-angle en a un grand. 27° correspondent à un objectif de 50 mm devant un film de 24 mm.</translation>
    </message>
    <message>
        <source>F-stop</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Mise au point</translation>
    </message>
    <message>
        <source>Distance at which the lens is in focus.</source>
        <translation>Distance à laquelle l’objectif est net.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>caméra</translation>
    </message>
    <message>
        <source>Camera: %1</source>
        <translation>Caméra : %1</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Caméra</translation>
    </message>
    <message>
        <source>Add a camera with the present view</source>
        <translation>Ajouter une caméra avec la vue actuelle</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>le fichier ne peut pas être écrit : %1</translation>
    </message>
    <message>
        <source>the scene has no file yet: save it first, its pictures are copied beside it</source>
        <translation>la scène n’a pas encore de fichier : enregistrez-la d’abord, ses images sont copiées à côté</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>Focal length over the opening of the lens: the smaller, the less is sharp. 0 leaves everything sharp. Seen in pictures, and in the view while it looks through the camera and nothing moves.</source>
        <translation>Focale divisée par l’ouverture de l’objectif : plus elle est petite, moins il y a de netteté. 0 laisse tout net. Se voit dans les images, et dans la vue tant qu’elle regarde par la caméra et que rien ne bouge.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: a name of 1 to %2 characters expected, without / \ : * ? &quot; &lt; &gt; | and without a dot in front</source>
        <translation>« %1 » : un nom de 1 à %2 caractères est attendu, sans / \ : * ? &quot; &lt; &gt; | et sans point au début</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: there is a preset of this name already</source>
        <translation>« %1 » : il y a déjà un modèle de ce nom</translation>
    </message>
    <message>
        <source>%1: there is no tree in it</source>
        <translation>%1 : ne contient aucun arbre</translation>
    </message>
    <message>
        <source>cannot make the folder %1</source>
        <translation>impossible de créer le dossier %1</translation>
    </message>
    <message>
        <source>%1: cannot be renamed: %2</source>
        <translation>%1 : impossible de le renommer : %2</translation>
    </message>
    <message>
        <source>%1: cannot be moved to the trash: %2</source>
        <translation>%1 : impossible de le mettre à la corbeille : %2</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Les vôtres</translation>
    </message>
    <message>
        <source>typical</source>
        <translation>typique</translation>
    </message>
    <message>
        <source>tall</source>
        <translation>élevé</translation>
    </message>
    <message>
        <source>low</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>wide</source>
        <translation>large</translation>
    </message>
    <message>
        <source>slender</source>
        <translation>élancé</translation>
    </message>
    <message>
        <source>stout</source>
        <translation>trapu</translation>
    </message>
    <message>
        <source>the obstacles leave no room for the crown</source>
        <translation>les obstacles ne laissent pas de place à la couronne</translation>
    </message>
    <message>
        <source>below the tree stands no solid that trees fill</source>
        <translation>sous l’arbre ne se trouve aucun solide que les arbres remplissent</translation>
    </message>
    <message>
        <source>%1 is not closed: it has no inside that a tree could fill</source>
        <translation>%1 n’est pas fermé : il n’a pas d’intérieur qu’un arbre pourrait remplir</translation>
    </message>
    <message>
        <source>%1 lies below the foot of the tree</source>
        <translation>%1 se trouve plus bas que le pied de l’arbre</translation>
    </message>
    <message>
        <source>The solid that the crown fills, round about the trunk; or solids of the scene, which stand below the tree and say that trees fill them.</source>
        <translation>Le solide que remplit la couronne, tout autour du tronc ; ou des solides de la scène, placés sous l’arbre et que les arbres doivent remplir.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Les arbres</translation>
    </message>
    <message>
        <source>Role for trees that grow by space colonisation. A tree whose envelope is “Solid” fills the solids below it in the scene; all such trees grow around obstacles. Hidden objects count, too.</source>
        <translation>Rôle pour les arbres qui poussent par colonisation de l’espace. Un arbre dont l’enveloppe est un solide remplit les solides placés sous lui dans la scène ; tous contournent les obstacles. Les objets cachés comptent aussi.</translation>
    </message>
    <message>
        <source>Solid of the scene</source>
        <translation>Solide de la scène</translation>
    </message>
    <message>
        <source>Are not concerned</source>
        <translation>Ne s’en soucient pas</translation>
    </message>
    <message>
        <source>Fill it</source>
        <translation>Le remplissent</translation>
    </message>
    <message>
        <source>Grow around it</source>
        <translation>Le contournent</translation>
    </message>
    <message>
        <source>no &lt;arbaro&gt; with a &lt;species&gt;: not a tree of Arbaro</source>
        <translation>ni &lt;arbaro&gt; ni &lt;species&gt; : ce n’est pas un arbre d’Arbaro</translation>
    </message>
    <message>
        <source>the XML is broken or cut off (%1)</source>
        <translation>le XML est abîmé ou coupé (%1)</translation>
    </message>
    <message>
        <source>a &lt;param&gt; needs a name and a value</source>
        <translation>un &lt;param&gt; a besoin d’un nom (name) et d’une valeur (value)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands here twice</source>
        <translation>« %1 » est là deux fois</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>« %1 » n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1 levels: only %2 grow</source>
        <translation>%1 niveaux : seuls %2 poussent</translation>
    </message>
    <message>
        <source>leaves in a fan stand along the twig instead</source>
        <translation>les feuilles en éventail se placent le long du rameau</translation>
    </message>
    <message>
        <source>%1 has no counterpart</source>
        <translation>%1 n’a pas d’équivalent</translation>
    </message>
    <message>
        <source>Tree of Arbaro</source>
        <translation>Arbre d’Arbaro</translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation>un nombre est attendu</translation>
    </message>
    <message>
        <source>a text is expected</source>
        <translation>un texte est attendu</translation>
    </message>
    <message>
        <source>a whole number from 0 to 3 is expected</source>
        <translation>un nombre entier de 0 à 3 est attendu</translation>
    </message>
    <message>
        <source>length and radius must be more than zero</source>
        <translation>la longueur et le rayon doivent dépasser zéro</translation>
    </message>
    <message>
        <source>for a picture of many leaves, %1 of them grow, each %2 times shorter</source>
        <translation>pour une image de plusieurs feuilles, il en pousse %1, chacune %2 fois plus courte</translation>
    </message>
    <message>
        <source>a unit of length is taken as a metre</source>
        <translation>une unité de longueur est lue comme un mètre</translation>
    </message>
    <message>
        <source>stems end in points, and are longer by the ones that went on from their ends</source>
        <translation>les tiges finissent en pointe, et s’allongent de celles qui continuaient à leur bout</translation>
    </message>
    <message>
        <source>the JSON is broken or cut off</source>
        <translation>le JSON est abîmé ou coupé</translation>
    </message>
    <message>
        <source>no &quot;branch&quot;: not a tree of ez-tree</source>
        <translation>aucun « branch » : ce n’est pas un arbre d’ez-tree</translation>
    </message>
    <message>
        <source>Tree of ez-tree</source>
        <translation>Arbre d’ez-tree</translation>
    </message>
    <message>
        <source>a file of parameters has no axes and no unit</source>
        <translation>un fichier de paramètres n’a ni axes ni unité</translation>
    </message>
    <message>
        <source>larger than 4 MiB: that is no file of parameters</source>
        <translation>plus de 4 Mio : ce n’est pas un fichier de paramètres</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>%1 is none of its choices</source>
        <translation>%1 n’est pas l’un de ses choix</translation>
    </message>
    <message>
        <source>leaves and bark are those of the preset %1</source>
        <translation>les feuilles et l’écorce sont celles du modèle %1</translation>
    </message>
    <message>
        <source>the leaves are those of &quot;%1&quot;, by the name</source>
        <translation>les feuilles sont celles de « %1 », d’après le nom</translation>
    </message>
    <message>
        <source>the plant is not known: the leaves are those of a beech</source>
        <translation>plante inconnue : les feuilles sont celles d’un hêtre</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoris</translation>
    </message>
    <message>
        <source>a GLB holds up to 4 GiB: fewer leaves or triangles</source>
        <translation>un GLB contient jusqu’à 4 Gio : moins de feuilles ou de triangles</translation>
    </message>
    <message>
        <source>a coordinate of %1 is not a finite number</source>
        <translation>une coordonnée de %1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>a GLB always has Y up and metres</source>
        <translation>un GLB a toujours Y en haut et des mètres</translation>
    </message>
    <message>
        <source>Binary glTF</source>
        <translation>glTF binaire</translation>
    </message>
    <message>
        <source>GLB (glTF), with materials and motion</source>
        <translation>GLB (glTF), avec matériaux et mouvement</translation>
    </message>
    <message>
        <source>only PNG and JPEG can stand in a GLB</source>
        <translation>un GLB ne contient que du PNG et du JPEG</translation>
    </message>
    <message>
        <source>no PNG that can be read: %1</source>
        <translation>ce n’est pas un PNG lisible : %1</translation>
    </message>
    <message>
        <source>%1 has more than 65535 joints: choose fewer</source>
        <translation>%1 a plus de 65535 articulations : choisissez-en moins</translation>
    </message>
    <message>
        <source>%1: %2 joints for %3 bones; no tip is more than %4 m from its place</source>
        <translation>%1 : %2 articulations pour %3 os ; aucun bout n’est à plus de %4 m de sa place</translation>
    </message>
    <message>
        <source>instances of leaves do not move: merge them, or write one moment</source>
        <translation>les instances de feuilles ne bougent pas : réunissez-les, ou écrivez un seul instant</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no such edit</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas cette modification</translation>
    </message>
    <message>
        <source>a JSON object is expected here</source>
        <translation>un objet JSON est attendu ici</translation>
    </message>
    <message>
        <source>every edit needs a name of its own</source>
        <translation>chaque modification doit avoir un nom à elle</translation>
    </message>
    <message>
        <source>there is no such tree</source>
        <translation>cet arbre n’existe pas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no such value</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas cette valeur</translation>
    </message>
    <message>
        <source>unknown operation &quot;%1&quot;</source>
        <translation>opération inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 numbers are expected here</source>
        <translation>%1 nombres sont attendus ici</translation>
    </message>
    <message>
        <source>&quot;tree&quot; or &quot;parent&quot; is expected here</source>
        <translation>«&#xa0;tree&#xa0;» ou «&#xa0;parent&#xa0;» est attendu ici</translation>
    </message>
    <message>
        <source>the limb is missing</source>
        <translation>la branche maîtresse manque</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Enlever</translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation>Ne garder que ceci</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Plier</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsader</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dessiner</translation>
    </message>
    <message>
        <source>Extend</source>
        <translation>Prolonger</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Redessiner</translation>
    </message>
    <message>
        <source>Graft</source>
        <translation>Greffer</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Prune to a shape</source>
        <translation>Tailler en forme</translation>
    </message>
    <message>
        <source>Attract</source>
        <translation>Attirer</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peigner</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Racine</translation>
    </message>
    <message>
        <source>a stroke needs between one and 100000 points</source>
        <translation>un trait a entre un et 100000 points</translation>
    </message>
    <message>
        <source>points need three finite coordinates and a radius that is not negative</source>
        <translation>les points ont trois coordonnées finies et un rayon qui n’est pas négatif</translation>
    </message>
    <message>
        <source>the stroke goes nowhere</source>
        <translation>le trait ne mène nulle part</translation>
    </message>
    <message>
        <source>the shape has no extent</source>
        <translation>la forme n’a pas d’étendue</translation>
    </message>
    <message>
        <source>a limb has at most 100000 pieces</source>
        <translation>une branche maîtresse a au plus 100000 morceaux</translation>
    </message>
    <message>
        <source>the pieces of a limb must follow their parents</source>
        <translation>les morceaux d’une branche maîtresse doivent suivre leurs parents</translation>
    </message>
    <message>
        <source>the pieces of an axis must follow each other</source>
        <translation>les morceaux d’un axe doivent se suivre</translation>
    </message>
    <message>
        <source>a graft needs a limb of this tree, or one of its own</source>
        <translation>une greffe demande une branche de cet arbre, ou la sienne</translation>
    </message>
    <message>
        <source>there is no such operation</source>
        <translation>cette opération n’existe pas</translation>
    </message>
    <message>
        <source>must be a finite number within its range</source>
        <translation>doit être un nombre fini, entre ses limites</translation>
    </message>
    <message>
        <source>must be three finite numbers</source>
        <translation>doit être trois nombres finis</translation>
    </message>
    <message>
        <source>a direction must not be zero</source>
        <translation>une direction ne doit pas être nulle</translation>
    </message>
    <message>
        <source>no limb of the tree resembles the edited one</source>
        <translation>aucune branche de l’arbre ne ressemble à celle qui a été retouchée</translation>
    </message>
    <message>
        <source>an edit before has taken the limb away</source>
        <translation>une modification d’avant a enlevé la branche</translation>
    </message>
    <message>
        <source>no branch is within reach</source>
        <translation>aucune branche n’est à portée</translation>
    </message>
    <message>
        <source>there is nothing above the bend</source>
        <translation>il n’y a rien au-dessus de la pliure</translation>
    </message>
    <message>
        <source>a curl must end above its start</source>
        <translation>un enroulement doit finir au-dessus de son début</translation>
    </message>
    <message>
        <source>nothing grows on this axis</source>
        <translation>rien ne pousse sur cet axe</translation>
    </message>
    <message>
        <source>only an axis on the ground has a root</source>
        <translation>seul un axe posé au sol a une racine</translation>
    </message>
    <message>
        <source>the tree has no such limb</source>
        <translation>l’arbre n’a pas cette branche</translation>
    </message>
    <message>
        <source>nothing of the tree would be left</source>
        <translation>il ne resterait rien de l’arbre</translation>
    </message>
    <message>
        <source>there is nothing above the cut</source>
        <translation>il n’y a rien au-dessus de la coupe</translation>
    </message>
    <message>
        <source>there is nothing else</source>
        <translation>il n’y a rien d’autre</translation>
    </message>
    <message>
        <source>nothing stands out of the shape</source>
        <translation>rien ne dépasse de la forme</translation>
    </message>
    <message>
        <source>a limb cannot be grafted into itself</source>
        <translation>une branche ne peut pas être greffée sur elle-même</translation>
    </message>
    <message>
        <source>the axis has no length</source>
        <translation>l’axe n’a pas de longueur</translation>
    </message>
    <message>
        <source>an axis on the ground has no place on a parent</source>
        <translation>un axe posé au sol n’a pas de place sur un parent</translation>
    </message>
    <message>
        <source>a limb cannot be put on itself</source>
        <translation>une branche ne peut pas être mise sur elle-même</translation>
    </message>
    <message>
        <source>pairs of radius and height are expected here</source>
        <translation>des paires de rayon et de hauteur sont attendues ici</translation>
    </message>
    <message>
        <source>a sphere, box, cone, profile or mesh is expected here</source>
        <translation>une sphère, une boîte, un cône, un profil ou un maillage est attendu ici</translation>
    </message>
    <message>
        <source>a profile needs two heights or more, upwards, and radii</source>
        <translation>un profil a deux hauteurs ou plus, vers le haut, et des rayons</translation>
    </message>
    <message>
        <source>a mesh needs four triangles or more between its points</source>
        <translation>un maillage a quatre triangles ou plus entre ses points</translation>
    </message>
    <message>
        <source>there is no such node</source>
        <translation>ce nœud n’existe pas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no solid</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un solide</translation>
    </message>
    <message>
        <source>the mesh is not closed: it has no inside</source>
        <translation>le maillage n’est pas fermé&#xa0;: il n’a pas d’intérieur</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has not grown yet</source>
        <translation>« %1 » n’a pas encore poussé</translation>
    </message>
    <message>
        <source>no branch is meant</source>
        <translation>aucune branche n’est désignée</translation>
    </message>
    <message>
        <source>nothing in there is thin enough to be cut</source>
        <translation>rien là-dedans n’est assez mince pour être coupé</translation>
    </message>
    <message>
        <source>no leaves there would come or go</source>
        <translation>aucune feuille n’y viendrait ni n’en partirait</translation>
    </message>
    <message>
        <source>an STL holds up to 4294967295 triangles</source>
        <translation>un STL contient au plus 4294967295 triangles</translation>
    </message>
    <message>
        <source>triangle %1 is not of finite numbers</source>
        <translation>le triangle %1 n’est pas fait de nombres finis</translation>
    </message>
    <message>
        <source>the file ends within a solid</source>
        <translation>le fichier s’arrête au milieu d’un solide</translation>
    </message>
    <message>
        <source>three vertices a loop expected</source>
        <translation>trois sommets attendus par boucle</translation>
    </message>
    <message>
        <source>not a line of an STL file: &quot;%1&quot;</source>
        <translation>pas une ligne d’un fichier STL : « %1 »</translation>
    </message>
    <message>
        <source>too short for an STL file</source>
        <translation>trop court pour un fichier STL</translation>
    </message>
    <message>
        <source>the size is not that of %1 triangles</source>
        <translation>la taille n’est pas celle de %1 triangles</translation>
    </message>
    <message>
        <source>the file holds more triangles than can be counted</source>
        <translation>le fichier contient plus de triangles qu’on ne peut en compter</translation>
    </message>
    <message>
        <source>the file holds no triangles</source>
        <translation>le fichier ne contient aucun triangle</translation>
    </message>
    <message>
        <source>STL</source>
        <translation>STL</translation>
    </message>
    <message>
        <source>STL, for printers</source>
        <translation>STL, pour imprimantes</translation>
    </message>
    <message>
        <source>a 3MF knows no kilometres: another unit, please</source>
        <translation>un 3MF ne connaît pas les kilomètres : choisissez une autre unité</translation>
    </message>
    <message>
        <source>3MF</source>
        <translation>3MF</translation>
    </message>
    <message>
        <source>3MF, for printers</source>
        <translation>3MF, pour imprimantes</translation>
    </message>
    <message>
        <source>the file holds no mesh to print</source>
        <translation>le fichier ne contient aucun maillage à imprimer</translation>
    </message>
    <message>
        <source>a document type has no place in a 3MF file</source>
        <translation>un type de document n’a pas sa place dans un fichier 3MF</translation>
    </message>
    <message>
        <source>a vertex without three finite numbers</source>
        <translation>un sommet sans trois nombres finis</translation>
    </message>
    <message>
        <source>a triangle with a vertex that does not exist</source>
        <translation>un triangle avec un sommet qui n’existe pas</translation>
    </message>
    <message>
        <source>objects that stand in another part of the archive are not read</source>
        <translation>les objets qui se trouvent dans une autre partie de l’archive ne sont pas lus</translation>
    </message>
    <message>
        <source>an object without a number, or a broken matrix</source>
        <translation>un objet sans numéro, ou une matrice abîmée</translation>
    </message>
    <message>
        <source>there is no object %1</source>
        <translation>il n’y a pas d’objet %1</translation>
    </message>
    <message>
        <source>components of components without an end</source>
        <translation>des composants de composants sans fin</translation>
    </message>
    <message>
        <source>the archive cannot be written: %1</source>
        <translation>l’archive ne peut pas être écrite : %1</translation>
    </message>
    <message>
        <source>not a ZIP archive, or a broken one</source>
        <translation>pas une archive ZIP, ou une archive abîmée</translation>
    </message>
    <message>
        <source>%1 would unpack to more than a file of this kind can hold</source>
        <translation>%1 serait, une fois décompressé, plus grand que ce qu’un tel fichier peut contenir</translation>
    </message>
    <message>
        <source>%1 is broken or cut off</source>
        <translation>%1 est abîmé ou tronqué</translation>
    </message>
    <message>
        <source>there is no %1 in the archive</source>
        <translation>il n’y a pas de %1 dans l’archive</translation>
    </message>
    <message>
        <source>Filament (FDM)</source>
        <translation>Filament (FDM)</translation>
    </message>
    <message>
        <source>Resin</source>
        <translation>Résine</translation>
    </message>
    <message>
        <source>Powder</source>
        <translation>Poudre</translation>
    </message>
    <message>
        <source>a print of %1 mm: a height from %2 to %3 mm expected</source>
        <translation>une impression de %1 mm : hauteur attendue de %2 à %3 mm</translation>
    </message>
    <message>
        <source>twigs of %1 mm: a thickness from %2 to %3 mm expected</source>
        <translation>des rameaux de %1 mm : épaisseur attendue de %2 à %3 mm</translation>
    </message>
    <message>
        <source>twigs of %1 mm are too thick for a print of %2 mm: a fifth at most</source>
        <translation>des rameaux de %1 mm sont trop épais pour une impression de %2 mm : un cinquième au plus</translation>
    </message>
    <message>
        <source>a print needs 1000 triangles at least</source>
        <translation>une impression a besoin d’au moins 1000 triangles</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: such as 180mm, 18cm or 7in expected</source>
        <translation>« %1 » n’est pas une longueur : par exemple 180mm, 18cm ou 7in</translation>
    </message>
    <message>
        <source>a tree that does not rise above its foot has no height</source>
        <translation>un arbre qui ne s’élève pas au-dessus de son pied n’a pas de hauteur</translation>
    </message>
    <message>
        <source>nothing of the tree would be thick enough: its trunk is %1 mm thick at this height. Print it higher (%2 mm), or allow thinner twigs</source>
        <translation>rien de l’arbre ne serait assez épais : à cette hauteur, son tronc a %1 mm d’épaisseur. Imprimez-le plus haut (%2 mm), ou permettez des rameaux plus fins</translation>
    </message>
    <message>
        <source>the branches could not be united into one surface: try another height</source>
        <translation>les branches n’ont pas pu être réunies en une seule surface : essayez une autre hauteur</translation>
    </message>
    <message>
        <source>a mesh that is no closed surface cannot be thinned out</source>
        <translation>un maillage qui n’est pas une surface fermée ne peut pas être allégé</translation>
    </message>
    <message>
        <source>nothing is left to print</source>
        <translation>il ne reste rien à imprimer</translation>
    </message>
    <message>
        <source>so large a print needs too fine a grid: lower it, or allow thicker twigs</source>
        <translation>une impression si grande demande une grille trop fine : réduisez-la, ou permettez des rameaux plus épais</translation>
    </message>
    <message>
        <source>one tree at a time is printed, and there are several: choose one</source>
        <translation>on imprime un arbre à la fois, et il y en a plusieurs : choisissez-en un</translation>
    </message>
    <message>
        <source>there is no visible tree to print</source>
        <translation>il n’y a aucun arbre visible à imprimer</translation>
    </message>
    <message>
        <source>a quote inside a cell: the whole cell has to be quoted</source>
        <translation>un guillemet dans une cellule : il faut mettre toute la cellule entre guillemets</translation>
    </message>
    <message>
        <source>a quote that is not closed</source>
        <translation>un guillemet n’est pas refermé</translation>
    </message>
    <message>
        <source>column %1 has no name</source>
        <translation>la colonne %1 n’a pas de nom</translation>
    </message>
    <message>
        <source>column &quot;%1&quot; is there twice</source>
        <translation>la colonne « %1 » y est deux fois</translation>
    </message>
    <message>
        <source>%1 cells, and there are %2 columns</source>
        <translation>%1 cellules, et il y a %2 colonnes</translation>
    </message>
    <message>
        <source>no columns: the first line names them</source>
        <translation>aucune colonne : la première ligne les nomme</translation>
    </message>
    <message>
        <source>Palms, bamboos and cacti</source>
        <translation>Palmiers, bambous et cactus</translation>
    </message>
    <message>
        <source>A clump of green canes that lean outwards under their leaves</source>
        <translation>Une touffe de cannes vertes qui s’inclinent vers l’extérieur sous leurs feuilles</translation>
    </message>
    <message>
        <source>A ribbed green column with raised arms and white flowers</source>
        <translation>Une colonne verte à côtes, aux bras levés et aux fleurs blanches</translation>
    </message>
    <message>
        <source>Cactus</source>
        <translation>Cactus</translation>
    </message>
    <message>
        <source>Crooked limbs in level tiers on a furrowed stem</source>
        <translation>Des branches tortueuses en étages horizontaux sur un tronc fissuré</translation>
    </message>
    <message>
        <source>%1 levels of detail: 1 to %2 are possible</source>
        <translation>%1 niveaux de détail : de 1 à %2 sont possibles</translation>
    </message>
    <message>
        <source>%1 levels of detail need as many budgets, not %2</source>
        <translation>%1 niveaux de détail demandent autant de budgets, pas %2</translation>
    </message>
    <message>
        <source>level %1: a budget of %2 triangles is less than the least, %3</source>
        <translation>niveau %1 : un budget de %2 triangles est en dessous du minimum, %3</translation>
    </message>
    <message>
        <source>level %1: budgets must fall, and %2 triangles are not fewer than %3</source>
        <translation>niveau %1 : les budgets doivent décroître, et %2 triangles ne sont pas moins que %3</translation>
    </message>
    <message>
        <source>the bark of a level does not pass its proof</source>
        <translation>l’écorce d’un niveau ne passe pas sa preuve</translation>
    </message>
    <message>
        <source>this tree has no level of %1 triangles: the nearest has %2</source>
        <translation>cet arbre n’a pas de niveau de %1 triangles : le plus proche en a %2</translation>
    </message>
    <message>
        <source>only the finished mesh has levels of detail</source>
        <translation>seul le maillage fini a des niveaux de détail</translation>
    </message>
    <message>
        <source>levels of detail have their leaves merged: no list of instances</source>
        <translation>les niveaux de détail ont leurs feuilles réunies : pas de liste d’instances</translation>
    </message>
    <message>
        <source>budgets are numbers of triangles, with commas between them</source>
        <translation>les budgets sont des nombres de triangles, séparés par des virgules</translation>
    </message>
    <message>
        <source>a leaf, fruit or flower is expected here</source>
        <translation>une feuille, un fruit ou une fleur est attendu ici</translation>
    </message>
    <message>
        <source>Place a leaf or fruit</source>
        <translation>Poser une feuille ou un fruit</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Fleur</translation>
    </message>
    <message>
        <source>level %1: a budget of %2 triangles is more than the most, %3</source>
        <translation>niveau %1 : un budget de %2 triangles dépasse le maximum, %3</translation>
    </message>
    <message>
        <source>the limb has been cut off already</source>
        <translation>la branche est déjà coupée</translation>
    </message>
    <message>
        <source>A small old pine with a bent trunk and limbs like trays</source>
        <translation>Un petit pin âgé au tronc courbé, aux branches en plateaux</translation>
    </message>
    <message>
        <source>Box, clipped to a block</source>
        <translation>Du buis taillé en bloc</translation>
    </message>
    <message>
        <source>a card shows nothing</source>
        <translation>une carte ne montre rien</translation>
    </message>
    <message>
        <source>a picture of cards has at least 16 pixels a side</source>
        <translation>une image de cartes a au moins 16 pixels de côté</translation>
    </message>
    <message>
        <source>%1 cards do not fit into a picture of %2 pixels</source>
        <translation>%1 cartes ne tiennent pas dans une image de %2 pixels</translation>
    </message>
    <message>
        <source>nothing is visible: there is nothing to make a billboard of</source>
        <translation>rien n’est visible : il n’y a rien dont faire un billboard</translation>
    </message>
    <message>
        <source>%1 joints: an arm has 1 to %2</source>
        <translation>%1 articulations : un bras en a de 1 à %2</translation>
    </message>
    <message>
        <source>two joints at one place</source>
        <translation>deux articulations à une même place</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>il n’y a pas de %1</translation>
    </message>
    <message>
        <source>fewer values than keys</source>
        <translation>moins de valeurs que de clés</translation>
    </message>
    <message>
        <source>a key at a time that cannot be</source>
        <translation>une clé à un temps impossible</translation>
    </message>
    <message>
        <source>keys that cannot be</source>
        <translation>des clés impossibles</translation>
    </message>
    <message>
        <source>%1 animations: the first one is taken</source>
        <translation>%1 animations : la première est prise</translation>
    </message>
    <message>
        <source>%1 numbers expected</source>
        <translation>%1 nombres attendus</translation>
    </message>
    <message>
        <source>the JSON of the file has more than %1 MiB</source>
        <translation>le JSON du fichier dépasse %1 Mio</translation>
    </message>
    <message>
        <source>this is no GLB file</source>
        <translation>ce n’est pas un fichier GLB</translation>
    </message>
    <message>
        <source>a GLB of version %1: 2 can be read</source>
        <translation>un GLB de version %1 : la version 2 peut être lue</translation>
    </message>
    <message>
        <source>the file is cut off: %1 of %2 bytes are there</source>
        <translation>le fichier est coupé : %1 octets sur %2 sont là</translation>
    </message>
    <message>
        <source>a part of the file goes beyond its end</source>
        <translation>une partie du fichier dépasse sa fin</translation>
    </message>
    <message>
        <source>the file has no JSON part</source>
        <translation>le fichier n’a pas de partie JSON</translation>
    </message>
    <message>
        <source>the JSON of the file is broken</source>
        <translation>le JSON du fichier est abîmé</translation>
    </message>
    <message>
        <source>the file needs %1, which cannot be read</source>
        <translation>le fichier exige %1, qui ne peut être lu</translation>
    </message>
    <message>
        <source>%1 bytes expected, %2 are there</source>
        <translation>%1 octets attendus, %2 sont là</translation>
    </message>
    <message>
        <source>a buffer in another file, or broken: export it as one GLB</source>
        <translation>un tampon dans un autre fichier, ou abîmé : exportez un seul GLB</translation>
    </message>
    <message>
        <source>it goes beyond its buffer</source>
        <translation>il dépasse son tampon</translation>
    </message>
    <message>
        <source>it would unpack to more than a mesh can be</source>
        <translation>il se déploierait en plus qu’un maillage ne peut être</translation>
    </message>
    <message>
        <source>the compressed bytes are broken</source>
        <translation>les octets compressés sont abîmés</translation>
    </message>
    <message>
        <source>%1 numbers an element expected</source>
        <translation>%1 nombres par élément attendus</translation>
    </message>
    <message>
        <source>%1 elements without bytes are more than a mesh needs</source>
        <translation>%1 éléments sans octets sont plus qu’un maillage n’en demande</translation>
    </message>
    <message>
        <source>it goes beyond its view</source>
        <translation>il dépasse sa vue</translation>
    </message>
    <message>
        <source>the sparse values are broken</source>
        <translation>les valeurs éparses sont abîmées</translation>
    </message>
    <message>
        <source>whole numbers from 0 on expected</source>
        <translation>nombres entiers à partir de 0 attendus</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>un nombre n’est pas fini</translation>
    </message>
    <message>
        <source>not as many as there are positions</source>
        <translation>pas autant que de positions</translation>
    </message>
    <message>
        <source>a vertex follows a joint that the skin has not</source>
        <translation>un sommet suit une articulation que la peau n’a pas</translation>
    </message>
    <message>
        <source>a child that does not exist</source>
        <translation>un enfant qui n’existe pas</translation>
    </message>
    <message>
        <source>%1 stands below two nodes</source>
        <translation>%1 est sous deux nœuds</translation>
    </message>
    <message>
        <source>a node that does not exist, or not at the top</source>
        <translation>un nœud qui n’existe pas, ou pas au sommet</translation>
    </message>
    <message>
        <source>more than %1 copies</source>
        <translation>plus de %1 copies</translation>
    </message>
    <message>
        <source>a joint that is no node</source>
        <translation>une articulation qui n’est pas un nœud</translation>
    </message>
    <message>
        <source>a skin without joints</source>
        <translation>une peau sans articulations</translation>
    </message>
    <message>
        <source>fewer bind matrices than joints</source>
        <translation>moins de matrices de liaison que d’articulations</translation>
    </message>
    <message>
        <source>the file shows no mesh, no camera and no node</source>
        <translation>le fichier ne montre ni maillage, ni caméra, ni nœud</translation>
    </message>
    <message>
        <source>%1 is sheared, mirrored or flat: its children took over this part of the transform</source>
        <translation>%1 est cisaillé, en miroir ou aplati : ses enfants ont repris cette part de la transformation</translation>
    </message>
    <message>
        <source>the camera %1 has no angle that can be kept: it gets the usual one</source>
        <translation>la caméra %1 n’a pas d’angle qui puisse être gardé : elle reçoit l’angle habituel</translation>
    </message>
    <message>
        <source>the joints of %1 make no arm: it stays a mesh, in the pose of the first frame</source>
        <translation>les articulations de %1 ne font pas un bras : il reste un maillage, dans la pose de la première image</translation>
    </message>
    <message>
        <source>%1 pictures of materials are in %2 now</source>
        <translation>%1 images de matériaux sont maintenant dans %2</translation>
    </message>
    <message>
        <source>%1 shows no mesh</source>
        <translation>%1 ne montre aucun maillage</translation>
    </message>
    <message>
        <source>a hundred other pictures of this name are there</source>
        <translation>cent autres images de ce nom sont là</translation>
    </message>
    <message>
        <source>a picture of more than %1 pixels a side</source>
        <translation>une image de plus de %1 pixels de côté</translation>
    </message>
    <message>
        <source>the texture cannot be written: %1</source>
        <translation>la texture ne peut être écrite : %1</translation>
    </message>
    <message>
        <source>wind data are of a tree at rest: write it at time 0</source>
        <translation>les données de vent sont celles d’un arbre au repos : écrivez-le à l’instant 0</translation>
    </message>
    <message>
        <source>only a GLB holds wind data</source>
        <translation>seul un GLB contient des données de vent</translation>
    </message>
    <message>
        <source>only the finished mesh has wind data</source>
        <translation>seul le maillage fini a des données de vent</translation>
    </message>
    <message>
        <source>wind data are of merged leaves: instances of one shape have one shape&apos;s</source>
        <translation>les données de vent sont de feuilles fondues : les instances d’une forme n’ont que celles de la forme</translation>
    </message>
    <message>
        <source>wind data and an animation exclude each other</source>
        <translation>données de vent et animation s’excluent</translation>
    </message>
    <message>
        <source>Pivot Painter has room for %1 trunks</source>
        <translation>Pivot Painter a place pour %1 troncs</translation>
    </message>
    <message>
        <source>Any shader (_WIND)</source>
        <translation>Tout shader (_WIND)</translation>
    </message>
    <message>
        <source>CryEngine (vertex colours)</source>
        <translation>CryEngine (couleurs de sommets)</translation>
    </message>
    <message>
        <source>Unity (Tree Creator)</source>
        <translation>Unity (Tree Creator)</translation>
    </message>
    <message>
        <source>Unreal (Pivot Painter 2)</source>
        <translation>Unreal (Pivot Painter 2)</translation>
    </message>
    <message>
        <source>nothing of the picture is transparent</source>
        <translation>rien de l’image n’est transparent</translation>
    </message>
    <message>
        <source>only the finest level of detail is taken</source>
        <translation>seul le niveau de détail le plus fin est pris</translation>
    </message>
    <message>
        <source>%1 levels of detail change %2 times: as many distances or shares expected, not %3</source>
        <translation>%1 niveaux de détail changent %2 fois : il faut autant de distances ou de parts, et non %3</translation>
    </message>
    <message>
        <source>level %1: its share of the picture&apos;s height must be over 0</source>
        <translation>niveau %1 : sa part de la hauteur de l’image doit dépasser 0</translation>
    </message>
    <message>
        <source>level %1: its distance must be over 0</source>
        <translation>niveau %1 : sa distance doit dépasser 0</translation>
    </message>
    <message>
        <source>level %1: %2 % of the picture&apos;s height is more than the most, %3 %</source>
        <translation>niveau %1 : %2 % de la hauteur de l’image dépasse le maximum, %3 %</translation>
    </message>
    <message>
        <source>level %1: shares of the picture must fall, and %2 % is not less than %3 %</source>
        <translation>niveau %1 : les parts de l’image doivent décroître, et %2 % n’est pas moins que %3 %</translation>
    </message>
    <message>
        <source>level %1: distances must rise, and %2 m is not farther than %3 m</source>
        <translation>niveau %1 : les distances doivent croître, et %2 m n’est pas plus loin que %3 m</translation>
    </message>
    <message>
        <source>levels change at distances or at shares of the picture, not at both</source>
        <translation>les niveaux changent à des distances ou à des parts de l’image, pas aux deux</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: a distance in metres, or a share of the picture such as 30 %, expected</source>
        <translation>« %1 » : il faut une distance en mètres, ou une part de l’image comme 30 %</translation>
    </message>
    <message>
        <source>Branches thinner than this share of the trunk&apos;s radius carry leaves and fruit. 0 leaves the tree bare.</source>
        <translation>Les branches plus minces que cette part du rayon du tronc portent des feuilles et des fruits. 0 laisse l’arbre nu.</translation>
    </message>
    <message>
        <source>Amount of fruit</source>
        <translation>Quantité de fruits</translation>
    </message>
    <message>
        <source>The chance that a branch which is thin enough carries fruit, of the kind below: 0 for none, 1 for one on each.</source>
        <translation>La chance qu’une branche assez mince porte des fruits, de la sorte ci-dessous : 0 pour aucun, 1 pour chacune.</translation>
    </message>
    <message>
        <source>Blue spruce</source>
        <translation>Épicéa bleu</translation>
    </message>
    <message>
        <source>Ground clearance</source>
        <translation>Hauteur libre au sol</translation>
    </message>
    <message>
        <source>Limbs that sink to this height continue level, and their twigs end above the ground. At 0 they may grow below the ground.</source>
        <translation>Les branches qui descendent à cette hauteur poursuivent à l’horizontale, et leurs rameaux s’arrêtent au-dessus du sol. À 0, elles peuvent descendre plus bas.</translation>
    </message>
    <message>
        <source>Number of leaves on each branch that is thin enough. Leaves of a plant follow their internode instead; for them only 0 has an effect: no leaves.</source>
        <translation>Nombre de feuilles sur chaque branche assez mince. Les feuilles d’une plante suivent plutôt leur entre-nœud ; pour elles seul 0 a un effet : aucune feuille.</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1</source>
        <translation>impossible de créer un dossier temporaire : %1</translation>
    </message>
    <message>
        <source>node</source>
        <translation>nœud</translation>
    </message>
    <message>
        <source>%1: this version of Ramure does not know its kind</source>
        <translation>%1 : cette version de Ramure ne connaît pas ce genre de nœud</translation>
    </message>
    <message>
        <source>points without faces: a group stands in their place</source>
        <translation>des points sans faces : un groupe est à leur place</translation>
    </message>
    <message>
        <source>the meshes of the file have no triangles: there is no surface to read</source>
        <translation>les maillages du fichier n’ont pas de triangles : il n’y a pas de surface à lire</translation>
    </message>
    <message>
        <source>the picture &quot;%1&quot; stands in another file</source>
        <translation>l’image « %1 » est dans un autre fichier</translation>
    </message>
    <message>
        <source>the picture &quot;%1&quot; is neither a PNG nor a JPEG</source>
        <translation>l’image « %1 » n’est ni un PNG ni un JPEG</translation>
    </message>
    <message>
        <source>the file holds %1 points and no faces: there is no surface to read</source>
        <translation>le fichier contient %1 points et aucune face : il n’y a pas de surface à lire</translation>
    </message>
    <message>
        <source>%1 grows branches here and is not read as &quot;%2&quot;: write &quot;%2&quot;, or put a backquote in front of it to keep it</source>
        <translation>%1 fait pousser des branches ici et n’est pas lu comme « %2 » : écrivez « %2 », ou mettez un accent grave devant pour le garder</translation>
    </message>
    <message>
        <source>%1 is read as several symbols, one per byte, and each of them grows a branch</source>
        <translation>%1 est lu comme plusieurs symboles, un par octet, dont chacun fait pousser une branche</translation>
    </message>
    <message>
        <source>%1 grows branches here: remove it, or put a backquote in front of it to keep it</source>
        <translation>%1 fait pousser des branches ici : supprimez-le, ou mettez un accent grave devant pour le garder</translation>
    </message>
    <message>
        <source>this line is a comment: %1 is only read in the language &quot;Modules with numbers&quot; (grammar.dialect=parametric)</source>
        <translation>cette ligne est un commentaire : %1 n’est lu que dans le langage « Modules avec nombres » (grammar.dialect=parametric)</translation>
    </message>
    <message>
        <source>numbers, contexts and conditions belong to the language &quot;Modules with numbers&quot; (grammar.dialect=parametric)</source>
        <translation>les nombres, les contextes et les conditions appartiennent au langage « Modules avec nombres » (grammar.dialect=parametric)</translation>
    </message>
    <message>
        <source>%1 has no meaning here: remove it</source>
        <translation>%1 n’a pas de sens ici : supprimez-le</translation>
    </message>
    <message>
        <source>%1 is not &quot;%2&quot;: write &quot;%2&quot;</source>
        <translation>%1 n’est pas « %2 » : écrivez « %2 »</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a number nor a function</source>
        <translation>« %1 » n’est ni un nombre ni une fonction</translation>
    </message>
    <message>
        <source>macros with parameters are not supported: write &quot;%1&quot; out at each use</source>
        <translation>les macros à paramètres ne sont pas prises en charge : écrivez « %1 » en toutes lettres à chaque usage</translation>
    </message>
    <message>
        <source>the axiom does not belong among the rules: write it under Axiom (grammar.axiom)</source>
        <translation>l’axiome n’a pas sa place parmi les règles : écrivez-le sous Axiome (grammar.axiom)</translation>
    </message>
    <message>
        <source>the number of steps does not belong among the rules: set Iterations (grammar.iterations)</source>
        <translation>le nombre d’étapes n’a pas sa place parmi les règles : réglez Itérations (grammar.iterations)</translation>
    </message>
    <message>
        <source>a weight stands before its outcome: &quot;0.5: F | 0.5: FF&quot;</source>
        <translation>un poids se place devant son issue : « 0.5: F | 0.5: FF »</translation>
    </message>
    <message>
        <source>tables of colours are not supported: leave &apos; out</source>
        <translation>les tables de couleurs ne sont pas prises en charge : supprimez le signe &apos;</translation>
    </message>
    <message>
        <source>polygons are not supported: write an organ such as ~(leaf, 0.1) instead</source>
        <translation>les polygones ne sont pas pris en charge : écrivez plutôt un organe comme ~(leaf, 0.1)</translation>
    </message>
    <message>
        <source>a module is expected here: a letter, a digit or one of %1</source>
        <translation>un module est attendu ici : une lettre, un chiffre ou l’un de %1</translation>
    </message>
    <message>
        <source>files are not included: paste the text of the file here, or write an organ such as ~(leaf, 0.1) for a shape</source>
        <translation>les fichiers ne sont pas inclus : collez ici le texte du fichier, ou écrivez un organe comme ~(leaf, 0.1) pour une forme</translation>
    </message>
    <message>
        <source>this comment is never closed: &quot;*/&quot; is missing</source>
        <translation>ce commentaire n’est jamais fermé : « */ » manque</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 is used instead</source>
        <translation>%1 est hors limites : %2 le remplace</translation>
    </message>
    <message>
        <source>Extra thickness of the trunk at the ground, as a share of its radius. Negative values make it thinner.</source>
        <translation>Épaisseur en plus du tronc au sol, comme part de son rayon. Une valeur négative l’amincit.</translation>
    </message>
    <message>
        <source>Angle between a stem and its parent: 0 continues straight, a quarter turn stands off at a right angle. For the trunk, the angle to the vertical. Negative: to the other side.</source>
        <translation>Angle entre une tige et celle qui la porte : 0 continue tout droit, un quart de tour s’en écarte à angle droit. Pour le tronc, l’angle avec la verticale. Négatif : de l’autre côté.</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>le dossier ne peut être créé : %1</translation>
    </message>
    <message>
        <source>text behind a quoted cell: a separator expected</source>
        <translation>du texte après une cellule entre guillemets : un séparateur est attendu</translation>
    </message>
    <message>
        <source>column &quot;%1&quot;: bytes that are no text in UTF-8 or UTF-16</source>
        <translation>colonne « %1 » : des octets qui ne sont pas du texte en UTF-8 ou en UTF-16</translation>
    </message>
    <message>
        <source>this is neither UTF-8 nor whole UTF-16</source>
        <translation>ce n’est ni de l’UTF-8, ni de l’UTF-16 entier</translation>
    </message>
    <message>
        <source>Least radius</source>
        <translation>Rayon minimal</translation>
    </message>
    <message>
        <source>Branches of the mesh are made no thinner than this, and no two of its vertices lie closer together than about half of it: at 0.25 mm, programs that merge vertices within 0.1 mm keep the mesh closed. No more than a two-thousandth of the size of the tree is taken, and where branches have more than 12 points around, these may lie closer. 0 leaves the thinnest twigs as they are.</source>
        <translation>Dans le maillage, aucune branche n’est plus fine, et deux sommets ne sont jamais plus proches que la moitié environ&#xa0;: à 0,25 mm, les programmes qui fusionnent les sommets à moins de 0,1 mm gardent le maillage fermé. Au plus un deux-millième de la taille de l’arbre est pris, et là où les branches ont plus de 12 points sur leur tour, ceux-ci peuvent être plus proches. 0 laisse les rameaux les plus fins tels quels.</translation>
    </message>
    <message>
        <source>Distance above a fork, in diameters of the branch, over which a branch narrows from its parent&apos;s width to its own. At 0 it begins with its own width, which leaves a ledge if it is thinner.</source>
        <translation>Distance au-dessus d’une fourche, en diamètres de la branche, sur laquelle une branche s’amincit de la largeur de celle qui la porte à la sienne. À 0 elle commence à sa propre largeur, ce qui laisse un rebord si elle est plus mince.</translation>
    </message>
    <message>
        <source>Finished mesh</source>
        <translation>Maillage fini</translation>
    </message>
    <message>
        <source>Rough model</source>
        <translation>Modèle ébauché</translation>
    </message>
    <message>
        <source>Skeleton as lines</source>
        <translation>Squelette en lignes</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Texture coordinates</source>
        <translation>Coordonnées de texture</translation>
    </message>
    <message>
        <source>Merged into one mesh</source>
        <translation>Réunis en un maillage</translation>
    </message>
    <message>
        <source>List of instances</source>
        <translation>Liste d’instances</translation>
    </message>
    <message>
        <source>Leaves and fruit</source>
        <translation>Feuilles et fruits</translation>
    </message>
    <message>
        <source>Merged: the file holds every leaf and every fruit. List of instances: it holds the rest, and beside it stand a table, FILE_leaves.csv, with a row for each leaf, fruit and flower (its shape, material, branch, colour and matrix), and one OBJ for each shape; in a GLB or USD file they stand inside. Much smaller, for programs that draw instances.</source>
        <translation>Réunis : le fichier contient chaque feuille et chaque fruit. Liste d’instances : il contient le reste, et à côté se trouvent une table, FICHIER_leaves.csv, avec une ligne par feuille, fruit et fleur (forme, matériau, branche, couleur et matrice), et un OBJ par forme ; dans un GLB ou un fichier USD elles sont à l’intérieur. Bien plus petit, pour les programmes qui dessinent des instances.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Sans</translation>
    </message>
    <message>
        <source>%1 × %1 pixels</source>
        <translation>%1 × %1 pixels</translation>
    </message>
    <message>
        <source>Size of the pictures of bark and leaves that the program makes: inside a GLB, beside an OBJ</source>
        <translation>Taille des images d’écorce et de feuilles que fait le programme : dans un GLB, à côté d’un OBJ</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation>Compressé</translation>
    </message>
    <message>
        <source>Rounds numbers to visible precision and packs them (EXT_meshopt_compression): without its pictures, the file is about a fifth as large. For web pages and engines that read it; Blender 3.4 does not.</source>
        <translation>Arrondit les nombres à la précision visible et les comprime (EXT_meshopt_compression) : sans ses images, le fichier est réduit à un cinquième environ. Pour les pages web et les moteurs qui le lisent ; Blender 3.4 ne le lit pas.</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>%1 au plus</translation>
    </message>
    <message>
        <source>All branches</source>
        <translation>Toutes les branches</translation>
    </message>
    <message>
        <source>Joints of each tree that moves: thin branches go with those that carry them. Engines limit how many a mesh may have; fewer cost less to play</source>
        <translation>Articulations de chaque arbre qui bouge : les branches minces vont avec celles qui les portent. Les moteurs limitent leur nombre par maillage ; moins coûtent moins à jouer</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Wind for</source>
        <translation>Vent pour</translation>
    </message>
    <message>
        <source>Writes texture coordinates for bark, leaves and fruit. The tree&apos;s parameter &quot;Bark tile&quot; is the size of one repeat of the bark, in metres. Beside an .obj, the pictures of the bark are written, too.</source>
        <translation>Écrit les coordonnées de texture de l’écorce, des feuilles et des fruits. Le paramètre « Carreau d’écorce » de l’arbre est la taille d’une répétition de l’écorce, en mètres. À côté d’un .obj, les images de l’écorce sont écrites aussi.</translation>
    </message>
    <message>
        <source>Data of each vertex by which the shaders of an engine move the tree in the wind: the phase of its branch, the size of its movement, the flutter of its leaves. The tree is exported at rest; Unreal gets two textures beside the file. The handbook&apos;s page “Files” has the formulas.</source>
        <translation>Données de chaque sommet par lesquelles les shaders d’un moteur font bouger l’arbre au vent : la phase de sa branche, l’ampleur du mouvement, le frémissement des feuilles. L’arbre est exporté au repos ; Unreal reçoit deux textures à côté du fichier. La page « Fichiers » du manuel donne les formules.</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y vers le haut</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z vers le haut</translation>
    </message>
    <message>
        <source>The axis of the file that points up: Y for most game engines and Maya, Z for Blender, 3ds Max and printers</source>
        <translation>L’axe du fichier qui pointe vers le haut : Y pour la plupart des moteurs de jeu et Maya, Z pour Blender, 3ds Max et les imprimantes</translation>
    </message>
    <message>
        <source>Axis that points up</source>
        <translation>Axe vers le haut</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>kilomètres</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <source>Length unit of the file</source>
        <translation>Unité de longueur du fichier</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>How many times larger than in the scene</source>
        <translation>Combien de fois plus grand que dans la scène</translation>
    </message>
    <message>
        <source>How the printer works: it says how thin a twig may be</source>
        <translation>Le fonctionnement de l’imprimante : il dit à quel point un rameau peut être fin</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Procédé</translation>
    </message>
    <message>
        <source>Height, mm</source>
        <translation>Hauteur, mm</translation>
    </message>
    <message>
        <source>From the ground to the top of the print</source>
        <translation>Du sol au sommet de l’impression</translation>
    </message>
    <message>
        <source>Thinnest twig, mm</source>
        <translation>Rameau le plus fin, mm</translation>
    </message>
    <message>
        <source>Least thickness of a twig. Thinner twigs are thickened, and twigs that would need more than 1.5 times their thickness are cut.</source>
        <translation>Épaisseur minimale d’un rameau. Les rameaux plus fins sont épaissis ; ceux qui devraient l’être de plus de 1,5 fois sont coupés.</translation>
    </message>
    <message>
        <source>Disc as a foot</source>
        <translation>Disque comme pied</translation>
    </message>
    <message>
        <source>Prints a disc below the trunk. If it is off, the trunk is cut flat at the ground</source>
        <translation>Imprime un disque sous le tronc. Sans lui, le tronc est coupé à plat au sol</translation>
    </message>
    <message>
        <source>Thick shells</source>
        <translation>Coques épaisses</translation>
    </message>
    <message>
        <source>Thick shells: each leaf is as thick as the thinnest twig and in one piece with its own. Small leaves are enlarged and fewer. Fruit stays off.</source>
        <translation>Coques épaisses : chaque feuille est aussi épaisse que le rameau le plus fin et d’un seul tenant avec le sien. Les petites feuilles sont agrandies et moins nombreuses. Les fruits ne sont pas imprimés.</translation>
    </message>
    <message>
        <source>Date palm</source>
        <translation>Dattier</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Dattes</translation>
    </message>
    <message>
        <source>Collar</source>
        <translation>Bourrelet</translation>
    </message>
    <message>
        <source>How much wider than its own radius a side limb is where it leaves a thicker branch. The collar narrows within about a diameter of the limb.</source>
        <translation>De combien une branche latérale est plus large que son propre rayon là où elle quitte une branche plus épaisse. Le bourrelet se resserre en un diamètre de la branche environ.</translation>
    </message>
    <message>
        <source>Roots</source>
        <translation>Racines</translation>
    </message>
    <message>
        <source>Main roots into which the foot of a trunk divides, three or more. They run out over the ground and sink. With 0 the trunk stands on the ground like a post.</source>
        <translation>Racines principales en lesquelles se divise le pied d’un tronc, trois ou plus. Elles courent sur le sol et s’y enfoncent. Avec 0, le tronc se dresse sur le sol comme un poteau.</translation>
    </message>
    <message>
        <source>Root length</source>
        <translation>Longueur des racines</translation>
    </message>
    <message>
        <source>How far from the trunk the roots sink into the ground, in diameters of the trunk. Each root is longer or shorter than that by its share of chance.</source>
        <translation>Distance du tronc à laquelle les racines s’enfoncent dans le sol, en diamètres du tronc. Le hasard rend chaque racine un peu plus longue ou plus courte.</translation>
    </message>
    <message>
        <source>Root height</source>
        <translation>Hauteur des racines</translation>
    </message>
    <message>
        <source>How high above the ground the roots leave the trunk, in diameters of the trunk: 1 gives the foot of an oak, 3 the buttresses of a kapok tree.</source>
        <translation>Hauteur au-dessus du sol où les racines quittent le tronc, en diamètres du tronc : 1 donne le pied d’un chêne, 3 les contreforts d’un fromager.</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pied</translation>
    </message>
    <message>
        <source>Drawn by hand</source>
        <translation>Dessiné à la main</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Au sol</translation>
    </message>
    <message>
        <source>Limbs along axes</source>
        <translation>Branches le long des axes</translation>
    </message>
    <message>
        <source>Whole, along axes</source>
        <translation>Entière, le long des axes</translation>
    </message>
    <message>
        <source>Whole, at tips</source>
        <translation>Entière, aux bouts</translation>
    </message>
    <message>
        <source>Where it grows</source>
        <translation>Où cela pousse</translation>
    </message>
    <message>
        <source>Sag</source>
        <translation>Affaissement</translation>
    </message>
    <message>
        <source>Gnarl</source>
        <translation>Tortuosité</translation>
    </message>
    <message>
        <source>Dead wood</source>
        <translation>Bois mort</translation>
    </message>
    <message>
        <source>Pipe rule</source>
        <translation>Règle des tuyaux</translation>
    </message>
    <message>
        <source>there is no step &quot;%1&quot;; there are: %2</source>
        <translation>il n’y a pas d’étape « %1 » ; il y a : %2</translation>
    </message>
    <message>
        <source>several steps are called &quot;%1&quot;: #N names one of %2</source>
        <translation>plusieurs étapes s’appellent « %1 » : #N en nomme une de %2</translation>
    </message>
    <message>
        <source>unknown parameter &quot;%1&quot;: `ramure-cli list params` shows those there are</source>
        <translation>paramètre inconnu « %1 » : `ramure-cli list params` montre ceux qu’il y a</translation>
    </message>
    <message>
        <source>the step &quot;%1&quot; has no &quot;%2&quot;</source>
        <translation>l’étape « %1 » n’a pas de « %2 »</translation>
    </message>
    <message>
        <source>no step has &quot;%1&quot;; there are: %2</source>
        <translation>aucune étape n’a « %1 » ; il y a : %2</translation>
    </message>
    <message>
        <source>several steps have &quot;%1&quot;: #N.%1 names one of %2</source>
        <translation>plusieurs étapes ont « %1 » : #N.%1 en nomme une de %2</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Seed of the step</source>
        <translation>Graine de l’étape</translation>
    </message>
    <message>
        <source>Another draw of this step alone: the rest of the tree stays.</source>
        <translation>Un autre tirage de cette étape seule : le reste de l’arbre ne change pas.</translation>
    </message>
    <message>
        <source>Grows</source>
        <translation>Pousse</translation>
    </message>
    <message>
        <source>Where it grows. Limbs along axes: each axis takes the place of its trunk. Whole, along axes: as twigs on a limb. Whole, at tips: axes go on with it. On the ground: beside the tree.</source>
        <translation>Où cela pousse. Branches le long des axes : chaque axe prend la place de son tronc. Entière, le long des axes : comme des rameaux sur une branche. Entière, aux bouts : les axes continuent avec elle. Au sol : à côté de l’arbre.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>How many grow on each axis.</source>
        <translation>Combien poussent sur chaque axe.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Lowest place on the axis at which one may grow, as a share of the axis&apos;s length.</source>
        <translation>Place la plus basse sur l’axe, en part de sa longueur.</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Highest place on the axis at which one may grow, as a share of the axis&apos;s length.</source>
        <translation>Place la plus haute sur l’axe, en part de sa longueur.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angle between a new shoot and the axis that carries it.</source>
        <translation>Angle entre la pousse et l’axe qui la porte.</translation>
    </message>
    <message>
        <source>Limbs along axes: 1 is as long as they are for a trunk of that length. Whole, on axes: its length as a share of the axis&apos;. On the ground: 1 is as its parameters say.</source>
        <translation>Branches le long des axes : 1 donne la longueur qu’elles ont pour un tronc de cette longueur. Entière, sur des axes : sa longueur en part de celle de l’axe. Au sol : 1 est ce que disent ses paramètres.</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Variantes</translation>
    </message>
    <message>
        <source>How many different ones are grown; the axes take them in turn. More take longer.</source>
        <translation>Combien de formes différentes poussent ; les axes les prennent tour à tour. Plus il y en a, plus c’est long.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>Position relative to the foot of the tree.</source>
        <translation>Position par rapport au pied de l’arbre.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <source>How many times as far as this wood gives way under its weight. Trees that have sagged while they were young and thin hang 5 to 20 times as far.</source>
        <translation>Combien de fois plus que ce que ce bois cède sous son poids. Les arbres qui se sont affaissés quand ils étaient jeunes et minces pendent 5 à 20 fois plus.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the green wood, in gigapascals: willow about 5, pine 8, oak 9, ash 10.</source>
        <translation>Le module de Young du bois vert, en gigapascals : saule environ 5, pin 8, chêne 9, frêne 10.</translation>
    </message>
    <message>
        <source>Load of a metre</source>
        <translation>Charge d’un mètre</translation>
    </message>
    <message>
        <source>Weight of leaves and fruit on one metre of twig thinner than a centimetre.</source>
        <translation>Poids des feuilles et des fruits sur un mètre de rameau plus mince qu’un centimètre.</translation>
    </message>
    <message>
        <source>How far an axis wanders from the direction that it had.</source>
        <translation>De combien un axe s’écarte de la direction qu’il avait.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>How long an axis runs from one turn to the next, in diameters of its foot.</source>
        <translation>Combien un axe court d’un tournant à l’autre, en diamètres de son pied.</translation>
    </message>
    <message>
        <source>By order</source>
        <translation>Par ordre</translation>
    </message>
    <message>
        <source>How much more each order wanders than the one it grows on; 1: all alike.</source>
        <translation>Combien chaque ordre erre de plus que celui qui le porte ; 1 : tous pareils.</translation>
    </message>
    <message>
        <source>Dead limbs</source>
        <translation>Branches mortes</translation>
    </message>
    <message>
        <source>How many of the axes that the step acts on have died, with all that grows on them.</source>
        <translation>Combien des axes où l’étape agit sont morts, avec tout ce qui pousse dessus.</translation>
    </message>
    <message>
        <source>In the shade</source>
        <translation>À l’ombre</translation>
    </message>
    <message>
        <source>How far those low on their parent die before those near its tip; 0: all alike.</source>
        <translation>Combien celles qui sont basses sur leur parent meurent avant celles de son bout ; 0 : toutes pareilles.</translation>
    </message>
    <message>
        <source>Lost twigs</source>
        <translation>Rameaux perdus</translation>
    </message>
    <message>
        <source>How many of its twigs a dead limb has lost.</source>
        <translation>Combien de ses rameaux une branche morte a perdus.</translation>
    </message>
    <message>
        <source>Broken at</source>
        <translation>Brisée à</translation>
    </message>
    <message>
        <source>Average place at which dead limbs have broken off, as a share of their length. At 100 % none is broken.</source>
        <translation>Place moyenne où les branches mortes se sont brisées, en part de leur longueur. À 100 %, aucune n’est brisée.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exposant</translation>
    </message>
    <message>
        <source>Exponent with which the radii of a branch&apos;s twigs add up to its own: 2 keeps the area of the wood (Leonardo), 3 makes limbs thin more slowly. Most trees lie between 2 and 2.6.</source>
        <translation>Exposant avec lequel les rayons portés s’additionnent : 2 garde la surface du bois (Léonard), 3 amincit les branches plus lentement. La plupart des arbres sont entre 2 et 2,6.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>Blends from the old radii (0) to those of the rule (1).</source>
        <translation>Passe des anciens rayons (0) à ceux de la règle (1).</translation>
    </message>
    <message>
        <source>Keep the foot</source>
        <translation>Garder le pied</translation>
    </message>
    <message>
        <source>Each trunk keeps the radius of its foot, and the radii of the twigs follow. If off, twigs begin with the radius below.</source>
        <translation>Chaque tronc garde le rayon de son pied, et les rayons des rameaux en découlent. Sinon, les rameaux commencent au rayon ci-dessous.</translation>
    </message>
    <message>
        <source>The radius with which every twig ends.</source>
        <translation>Le rayon au bout de chaque rameau.</translation>
    </message>
    <message>
        <source>How much thicker the trunk is at the ground: 0.5 makes it half as thick again.</source>
        <translation>De combien le tronc est plus épais au sol : 0,5 le rend une fois et demie plus épais.</translation>
    </message>
    <message>
        <source>How far up the swelling reaches: at this height a third of it is left.</source>
        <translation>Jusqu’où monte l’empattement : à cette hauteur, il en reste un tiers.</translation>
    </message>
    <message>
        <source>Limbs bend by their own weight</source>
        <translation>Les branches plient sous leur propre poids</translation>
    </message>
    <message>
        <source>Axes wander from side to side</source>
        <translation>Les axes errent d’un côté à l’autre</translation>
    </message>
    <message>
        <source>Some limbs have died and lost their twigs</source>
        <translation>Des branches sont mortes et ont perdu leurs rameaux</translation>
    </message>
    <message>
        <source>Thickness by the pipe rule</source>
        <translation>Épaisseur par la règle des tuyaux</translation>
    </message>
    <message>
        <source>Makes wood as thick as its load requires</source>
        <translation>Rend le bois aussi épais que sa charge le demande</translation>
    </message>
    <message>
        <source>The foot of the trunk swells</source>
        <translation>Le pied du tronc s’élargit</translation>
    </message>
    <message>
        <source>Twigs or trees that rules draw</source>
        <translation>Rameaux ou arbres que dessinent des règles</translation>
    </message>
    <message>
        <source>Limbs, branches and twigs, each level by its own numbers</source>
        <translation>Branches maîtresses, branches et rameaux, chaque niveau selon ses nombres</translation>
    </message>
    <message>
        <source>Branches that fill a crown of your shape</source>
        <translation>Branches qui remplissent une couronne de votre forme</translation>
    </message>
    <message>
        <source>Unknown step</source>
        <translation>Étape inconnue</translation>
    </message>
    <message>
        <source>a recipe keeps the source that it begins with</source>
        <translation>une recette garde la source par laquelle elle commence</translation>
    </message>
    <message>
        <source>a step goes to a number from 2 to that of the last step</source>
        <translation>une étape va à un numéro de 2 à celui de la dernière</translation>
    </message>
    <message>
        <source>a newer version of the program has made this step</source>
        <translation>une version plus récente du programme a fait cette étape</translation>
    </message>
    <message>
        <source>no axis meets the condition</source>
        <translation>aucun axe ne remplit la condition</translation>
    </message>
    <message>
        <source>the condition should end here</source>
        <translation>la condition devrait finir ici</translation>
    </message>
    <message>
        <source>nothing grows that has a length</source>
        <translation>rien ne pousse qui ait une longueur</translation>
    </message>
    <message>
        <source>the step would make more branches than there may be</source>
        <translation>l’étape ferait plus de branches qu’il ne peut y en avoir</translation>
    </message>
    <message>
        <source>nothing grows there</source>
        <translation>rien n’y pousse</translation>
    </message>
    <message>
        <source>A condition for the axes on which the step acts, as &quot;order = 1 and share &gt; 0.4&quot;. Names: order (0 is the trunk), share and s (where the axis starts on its parent), length, radius, azimuth, angle, height, forks. Empty: every axis. &quot;axes&quot; and addresses: those alone.</source>
        <translation>Une condition sur les axes où l’étape agit, comme « order = 1 and share &gt; 0.4 ». Noms : order (0 est le tronc), share et s (où l’axe part de son parent), length (longueur), radius (rayon), azimuth, angle, height (hauteur), forks (fourches). Vide : tous les axes. « axes » et des adresses : ceux-là seuls.</translation>
    </message>
    <message>
        <source>Frozen tree</source>
        <translation>Arbre gelé</translation>
    </message>
    <message>
        <source>Holds the result of the steps above: they do not run until this step is switched off or deleted</source>
        <translation>Garde le résultat des étapes du dessus : elles ne s’exécutent pas tant que cette étape n’est pas désactivée ou supprimée</translation>
    </message>
    <message>
        <source>the tree is missing</source>
        <translation>l’arbre manque</translation>
    </message>
    <message>
        <source>a step behind it is frozen already</source>
        <translation>une étape qui la suit est déjà gelée</translation>
    </message>
    <message>
        <source>enabled, values, move, remove or freeze is expected here</source>
        <translation>enabled, values, move, remove ou freeze est attendu ici</translation>
    </message>
    <message>
        <source>the address of an axis is expected here: digits 0-9, a-f</source>
        <translation>l’adresse d’un axe est attendue ici : chiffres 0-9, a-f</translation>
    </message>
    <message>
        <source>these are not the bytes of a tree</source>
        <translation>ces octets ne sont pas ceux d’un arbre</translation>
    </message>
    <message>
        <source>the tree has died at the age of %1 years for want of light</source>
        <translation>l’arbre est mort à l’âge de %1 ans, faute de lumière</translation>
    </message>
    <message>
        <source>Limbs as thick as trunks, crooked to their tips</source>
        <translation>Des branches grosses comme des troncs, tordues jusqu’au bout</translation>
    </message>
    <message>
        <source>Fine rising limbs, twigs in flat sprays</source>
        <translation>De fines branches dressées, des rameaux en éventails plats</translation>
    </message>
    <message>
        <source>A slender stem, its finest twigs hanging</source>
        <translation>Une tige élancée, dont les rameaux les plus fins pendent</translation>
    </message>
    <message>
        <source>A dense tall dome on bowed limbs</source>
        <translation>Un haut dôme dense sur des branches arquées</translation>
    </message>
    <message>
        <source>A short trunk under curtains of hanging shoots</source>
        <translation>Un tronc court sous des rideaux de pousses pendantes</translation>
    </message>
    <message>
        <source>A low spreading head of spurs and crooked limbs</source>
        <translation>Une tête basse et étalée, de lambourdes et de branches tordues</translation>
    </message>
    <message>
        <source>A stout twisted trunk under a loose grey crown</source>
        <translation>Un gros tronc tors sous une couronne grise et lâche</translation>
    </message>
    <message>
        <source>A column of limbs that rise along the trunk</source>
        <translation>Une colonne de branches dressées le long du tronc</translation>
    </message>
    <message>
        <source>A high crown in clouds on a bare red stem</source>
        <translation>Une haute couronne en nuages sur un tronc rouge et nu</translation>
    </message>
    <message>
        <source>A spire of whorls, each limb hung with twigs</source>
        <translation>Une flèche de verticilles, chaque branche tendue de rameaux</translation>
    </message>
    <message>
        <source>Level limbs in storeys, a flat top when old</source>
        <translation>Des branches à plat par étages, une cime plate dans la vieillesse</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Âge</translation>
    </message>
    <message>
        <source>Size of the grown tree</source>
        <translation>Taille de l’arbre adulte</translation>
    </message>
    <message>
        <source>Shoots</source>
        <translation>Pousses</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>Habit</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>Years since the tree was a seed. All ages belong to one life: a branch that exists at 40 existed at 30, or has grown since.</source>
        <translation>Années depuis la graine. Tous les âges sont d’une seule vie : une branche qui est là à 40 ans l’était à 30, ou a poussé depuis.</translation>
    </message>
    <message>
        <source>Leader until</source>
        <translation>Flèche jusqu’à</translation>
    </message>
    <message>
        <source>The year in which the trunk loses its lead and becomes a limb among limbs. Late: one trunk to the top. Early: a crown of many limbs on a short trunk.</source>
        <translation>L’année où le tronc perd son avance et devient une branche parmi d’autres. Tard : un seul tronc jusqu’en haut. Tôt : une couronne de beaucoup de branches sur un tronc court.</translation>
    </message>
    <message>
        <source>Mature at</source>
        <translation>Adulte à</translation>
    </message>
    <message>
        <source>Years until the height is nearly reached.</source>
        <translation>Années jusqu’à ce que la hauteur soit presque atteinte.</translation>
    </message>
    <message>
        <source>Height of the mature tree.</source>
        <translation>Hauteur de l’arbre adulte.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Envergure</translation>
    </message>
    <message>
        <source>Width of the mature crown.</source>
        <translation>Largeur de la couronne adulte.</translation>
    </message>
    <message>
        <source>Crown begins at</source>
        <translation>Début de la couronne</translation>
    </message>
    <message>
        <source>Length of the bare trunk, as a share of the height. In the mature tree, limbs below get no light.</source>
        <translation>Longueur du tronc nu, en part de la hauteur. Dans l’arbre adulte, les branches en dessous n’ont pas de lumière.</translation>
    </message>
    <message>
        <source>Height at which the crown is widest, as a share of the crown&apos;s height.</source>
        <translation>Hauteur à laquelle la couronne est la plus large, en part de sa hauteur.</translation>
    </message>
    <message>
        <source>Shape of the top</source>
        <translation>Forme de la cime</translation>
    </message>
    <message>
        <source>How the crown narrows towards its top: 0.2 as an umbrella, 0.5 round, 1 as a cone.</source>
        <translation>Comment la couronne se resserre vers la cime : 0,2 en parasol, 0,5 ronde, 1 en cône.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>How many shoots the crown has: 1 is usual. More take longer.</source>
        <translation>Combien de pousses a la couronne : 1 est l’usage. Plus il y en a, plus c’est long.</translation>
    </message>
    <message>
        <source>How many stems leave the ground, as of a birch in a clump or of a coppiced hazel.</source>
        <translation>Combien de tiges partent du sol, comme d’un bouleau en cépée ou d’un noisetier recépé.</translation>
    </message>
    <message>
        <source>From one bud to the next on a long shoot. Short ones make a finer tree, and take longer.</source>
        <translation>D’un bourgeon au suivant sur une pousse longue. Courts, ils font un arbre plus fin, et c’est plus long.</translation>
    </message>
    <message>
        <source>Phyllotaxis</source>
        <translation>Phyllotaxie</translation>
    </message>
    <message>
        <source>How buds follow each other along a shoot. Spiral: one at a time, turned on, as of oaks. Opposite: in crossed pairs, as of maples and ashes. Alternate: left and right in turn, as of beeches and lindens.</source>
        <translation>Comment les bourgeons se suivent le long d’une pousse. Spirale : un à la fois, tourné, comme chez les chênes. Opposée : par paires croisées, comme chez les érables et les frênes. Alterne : à gauche puis à droite, comme chez les hêtres et les tilleuls.</translation>
    </message>
    <message>
        <source>Divergence</source>
        <translation>Divergence</translation>
    </message>
    <message>
        <source>How far each bud of a spiral is turned about the shoot from the one before.</source>
        <translation>De combien chaque bourgeon d’une spirale est tourné autour de la pousse par rapport au précédent.</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Insertion</translation>
    </message>
    <message>
        <source>The angle between an axis and the shoots that leave it.</source>
        <translation>L’angle entre un axe et les pousses qui en partent.</translation>
    </message>
    <message>
        <source>Limbs of a whorl</source>
        <translation>Branches d’un verticille</translation>
    </message>
    <message>
        <source>How many limbs stand around the end of each year&apos;s shoot of the trunk, as of pines and spruces. 0: none do.</source>
        <translation>Combien de branches entourent le bout de la pousse annuelle du tronc, comme chez les pins et les épicéas. 0 : aucune.</translation>
    </message>
    <message>
        <source>Buds at the end</source>
        <translation>Bourgeons du bout</translation>
    </message>
    <message>
        <source>How many side buds stand around the end of each year&apos;s shoot.</source>
        <translation>Combien de bourgeons latéraux entourent le bout de la pousse de chaque année.</translation>
    </message>
    <message>
        <source>Acrotony</source>
        <translation>Acrotonie</translation>
    </message>
    <message>
        <source>Which buds of a year&apos;s shoot grow: 0 all alike, 1 only those near its end.</source>
        <translation>Quels bourgeons d’une pousse annuelle démarrent : 0 tous pareils, 1 seulement ceux du bout.</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>Ramification</translation>
    </message>
    <message>
        <source>How much of the vigour goes into side shoots: low makes long whips, high makes bushy twigs.</source>
        <translation>Quelle part de la vigueur va aux pousses latérales : peu fait de longues baguettes, beaucoup fait des rameaux touffus.</translation>
    </message>
    <message>
        <source>Short shoots</source>
        <translation>Rameaux courts</translation>
    </message>
    <message>
        <source>How weak a bud may be and still make a short shoot: 0 none does, 1 all do.</source>
        <translation>Combien un bourgeon peut être faible et faire encore un rameau court : 0 aucun, 1 tous.</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Ordres</translation>
    </message>
    <message>
        <source>How many orders of axes there may be: trunk, limbs, boughs and so on.</source>
        <translation>Combien d’ordres d’axes il peut y avoir : tronc, branches maîtresses, branches, et ainsi de suite.</translation>
    </message>
    <message>
        <source>Buds see</source>
        <translation>Les bourgeons voient</translation>
    </message>
    <message>
        <source>The resource that buds compete for. Light: the part of the sky that no leaves above hide. Room: free space in the crown, or in the solid that the tree fills.</source>
        <translation>Ce que les bourgeons se disputent. Lumière : la part du ciel que les feuilles au-dessus ne cachent pas. Place : l’espace libre dans la couronne, ou dans le solide que l’arbre remplit.</translation>
    </message>
    <message>
        <source>Shade tolerance</source>
        <translation>Tolérance à l’ombre</translation>
    </message>
    <message>
        <source>0: a light crown of few layers, as of birches and pines. 1: a deep and dense one, as of beeches and spruces.</source>
        <translation>0 : une couronne légère de peu de couches, comme chez les bouleaux et les pins. 1 : une couronne profonde et dense, comme chez les hêtres et les épicéas.</translation>
    </message>
    <message>
        <source>Shedding</source>
        <translation>Élagage</translation>
    </message>
    <message>
        <source>How soon branches in the shade fall: 0 they stay, 1 they go at once.</source>
        <translation>Quand les branches à l’ombre tombent : 0 elles restent, 1 elles partent aussitôt.</translation>
    </message>
    <message>
        <source>Towards the light</source>
        <translation>Vers la lumière</translation>
    </message>
    <message>
        <source>Sunlight</source>
        <translation>Ensoleillement</translation>
    </message>
    <message>
        <source>Light, as a share of the open sky&apos;s. With too little the tree dies.</source>
        <translation>Lumière, en part de celle du ciel dégagé. Avec trop peu, l’arbre meurt.</translation>
    </message>
    <message>
        <source>Apical control</source>
        <translation>Dominance apicale</translation>
    </message>
    <message>
        <source>How far limbs keep one axis each: 0 they fork evenly, 1 they are straight with short side shoots.</source>
        <translation>Combien chaque branche garde un seul axe : 0 elles fourchent à parts égales, 1 elles sont droites avec de courtes pousses latérales.</translation>
    </message>
    <message>
        <source>Length of side shoots</source>
        <translation>Longueur des latérales</translation>
    </message>
    <message>
        <source>The longest shoots of an order of axes, as a share of those of the order before.</source>
        <translation>Les plus longues pousses d’un ordre d’axes, en part de celles de l’ordre précédent.</translation>
    </message>
    <message>
        <source>Autonomy of limbs</source>
        <translation>Autonomie des branches</translation>
    </message>
    <message>
        <source>How much shoots grow out of their own leaves: 0 all vigour is shared out from the roots, 1 each limb is a tree of its own.</source>
        <translation>Combien les pousses vivent de leurs propres feuilles : 0 toute la vigueur est partagée depuis les racines, 1 chaque branche est un arbre à elle seule.</translation>
    </message>
    <message>
        <source>Vigour is shared</source>
        <translation>Partage de la vigueur</translation>
    </message>
    <message>
        <source>Sympodial</source>
        <translation>Sympodial</translation>
    </message>
    <message>
        <source>How likely an apex dies or flowers in a year, so that side buds go on, as of horse chestnuts and magnolias. A trunk that leads keeps its own.</source>
        <translation>Probabilité qu’un apex meure ou fleurisse dans l’année, si bien que des bourgeons latéraux continuent, comme chez les marronniers et les magnolias. Un tronc dominant garde le sien.</translation>
    </message>
    <message>
        <source>Reiteration</source>
        <translation>Réitération</translation>
    </message>
    <message>
        <source>How likely in a year a dormant bud in the light begins a tree anew, as on old oaks.</source>
        <translation>La chance, dans l’année, qu’un bourgeon dormant à la lumière recommence un arbre, comme sur les vieux chênes.</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Dressé</translation>
    </message>
    <message>
        <source>How much shoots turn upwards; below 0, downwards.</source>
        <translation>Combien les pousses se tournent vers le haut ; sous 0, vers le bas.</translation>
    </message>
    <message>
        <source>Weeping</source>
        <translation>Pleureur</translation>
    </message>
    <message>
        <source>How much the shoots of higher orders hang.</source>
        <translation>Combien pendent les pousses des ordres supérieurs.</translation>
    </message>
    <message>
        <source>Flat limbs</source>
        <translation>Branches plates</translation>
    </message>
    <message>
        <source>How flat side shoots stay, in tiers as of beeches, firs and cedars.</source>
        <translation>Combien les pousses latérales restent à plat, par étages comme chez les hêtres, les sapins et les cèdres.</translation>
    </message>
    <message>
        <source>Crookedness</source>
        <translation>Tortuosité</translation>
    </message>
    <message>
        <source>Pipe exponent</source>
        <translation>Exposant des tuyaux</translation>
    </message>
    <message>
        <source>Exponent with which the diameters of a branch&apos;s twigs add up to its own: 2 keeps the area of the wood, 3 makes slender trunks.</source>
        <translation>Exposant avec lequel les diamètres portés s’additionnent : 2 garde la surface du bois, 3 fait des troncs élancés.</translation>
    </message>
    <message>
        <source>Radius of twigs</source>
        <translation>Rayon des rameaux</translation>
    </message>
    <message>
        <source>Thickness of a shoot in its first year. The whole tree gets thicker with it.</source>
        <translation>Épaisseur d’une pousse dans sa première année. Tout l’arbre grossit avec elle.</translation>
    </message>
    <message>
        <source>Girth of the lost</source>
        <translation>Bois des perdues</translation>
    </message>
    <message>
        <source>How much of the wood that carried shed branches the stem keeps: thick trunks below open crowns.</source>
        <translation>Combien la tige garde du bois qui portait les branches tombées : de gros troncs sous des couronnes claires.</translation>
    </message>
    <message>
        <source>Sag of the years</source>
        <translation>Affaissement des années</translation>
    </message>
    <message>
        <source>Share of the bend under each year&apos;s new weight that stays.</source>
        <translation>Part de la courbure due au nouveau poids de chaque année qui reste.</translation>
    </message>
    <message>
        <source>Reaction wood</source>
        <translation>Bois de réaction</translation>
    </message>
    <message>
        <source>How soon leaning shoots turn up again.</source>
        <translation>À quelle vitesse les pousses penchées se redressent.</translation>
    </message>
    <message>
        <source>Method that makes the branches. Grammar: rules replace symbols, and a turtle draws them. Weber and Penn: trunk, limbs, branches and twigs, each level with its own numbers. Space colonisation: branches reach for points that fill a crown of your shape. Drawn by hand: the steps of the recipe draw all branches. Growth: shoots compete for light, year by year, and the tree has an age. Leaves, bark and motion stay.</source>
        <translation>Méthode qui fait les branches. Grammaire : des règles remplacent des symboles, et une tortue les dessine. Weber et Penn : tronc, branches maîtresses, branches et rameaux, chaque niveau avec ses propres nombres. Colonisation de l’espace : les branches cherchent à atteindre des points qui remplissent une couronne de votre forme. Dessiné à la main : les étapes de la recette dessinent toutes les branches. Croissance : les pousses se disputent la lumière, année après année, et l’arbre a un âge. Feuilles, écorce et mouvement restent.</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>Weber and Penn 1995</source>
        <translation>Weber et Penn 1995</translation>
    </message>
    <message>
        <source>Shoots that compete for light, year by year</source>
        <translation>Des pousses qui se disputent la lumière, année après année</translation>
    </message>
    <message>
        <source>At forks: each fork shares by the light above it (Borchert and Honda). By rank: along each axis, so that few buds get most of it.</source>
        <translation>Aux fourches : chaque fourche partage selon la lumière au-dessus d’elle (Borchert et Honda). Par rang : le long de chaque axe, si bien que peu de bourgeons en ont le plus.</translation>
    </message>
    <message>
        <source>At forks</source>
        <translation>Aux fourches</translation>
    </message>
    <message>
        <source>By rank</source>
        <translation>Par rang</translation>
    </message>
    <message>
        <source>the limb did not stand when the tree was of that age</source>
        <translation>la branche n’existait pas quand l’arbre avait cet âge</translation>
    </message>
    <message>
        <source>there is nothing that could grow on</source>
        <translation>il n’y a rien qui puisse vivre encore</translation>
    </message>
    <message>
        <source>the tree has died for want of light</source>
        <translation>l’arbre est mort faute de lumière</translation>
    </message>
    <message>
        <source>Grow on</source>
        <translation>Vivre encore</translation>
    </message>
    <message>
        <source>Years</source>
        <translation>Années</translation>
    </message>
    <message>
        <source>How many years the tree lives on.</source>
        <translation>Combien d’années l’arbre vit encore.</translation>
    </message>
    <message>
        <source>The tree lives some years longer: shoots look for light, shaded limbs fall</source>
        <translation>L’arbre vit quelques années de plus : des pousses cherchent la lumière, les branches à l’ombre tombent</translation>
    </message>
    <message>
        <source>a tree with a limb that is about to fall cannot grow on</source>
        <translation>un arbre dont une branche va tomber ne peut pas vivre encore</translation>
    </message>
    <message>
        <source>yr</source>
        <translation>ans</translation>
    </message>
    <message>
        <source>Branching: shoots that compete for light. Palm: one stem that never branches under a crown of fronds, which open, bow and fall as they get older.</source>
        <translation>Ramifié : des pousses qui se disputent la lumière. Palmier : un seul stipe, qui ne se ramifie jamais, sous une couronne de palmes qui s’ouvrent, s’arquent et tombent avec l’âge.</translation>
    </message>
    <message>
        <source>How much chance turns each internode; how far the stem of a palm leans.</source>
        <translation>Combien le hasard tourne chaque entre-nœud ; combien le stipe d’un palmier penche.</translation>
    </message>
    <message>
        <source>Fronds a year</source>
        <translation>Palmes par an</translation>
    </message>
    <message>
        <source>How many fronds open in a year of the grown palm. The crown carries as many as open within the life of one.</source>
        <translation>Combien de palmes s’ouvrent en un an sur le palmier adulte. La couronne en porte autant qu’il s’en ouvre pendant la vie d’une palme.</translation>
    </message>
    <message>
        <source>Length of fronds</source>
        <translation>Longueur des palmes</translation>
    </message>
    <message>
        <source>Length of a frond from the stem to the tip, on the grown palm. Fronds of a seedling have a fifth of it.</source>
        <translation>Longueur d’une palme du stipe à la pointe, sur le palmier adulte. Celles d’une plantule en ont le cinquième.</translation>
    </message>
    <message>
        <source>Life of fronds</source>
        <translation>Vie des palmes</translation>
    </message>
    <message>
        <source>Years from the day a frond opens until it falls.</source>
        <translation>Années entre l’ouverture d’une palme et sa chute.</translation>
    </message>
    <message>
        <source>Radius of the stem</source>
        <translation>Rayon du stipe</translation>
    </message>
    <message>
        <source>Above its swollen foot. The stem of a palm has its width before it rises, and keeps it.</source>
        <translation>Au-dessus du pied renflé. Le stipe d’un palmier a sa largeur avant de s’élever, et la garde.</translation>
    </message>
    <message>
        <source>Fruit of a bunch</source>
        <translation>Fruits par régime</translation>
    </message>
    <message>
        <source>How many a bunch carries, in the axil of every other frond. They swell within a year. 0: none.</source>
        <translation>Combien en porte un régime, à l’aisselle d’une palme sur deux. Ils grossissent en un an. 0 : aucun.</translation>
    </message>
    <message>
        <source>A leaning stem that never branches under a crown of fronds</source>
        <translation>Un stipe penché qui ne se ramifie jamais, sous une couronne de palmes</translation>
    </message>
    <message>
        <source>Fairing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>How far the surface around forks of thick wood is smoothed, from the walls between the branches to the cross-sections beside them. 0 leaves it as it is built.</source>
        <translation>Jusqu’où la surface autour des fourches de bois épais est lissée, des parois entre les branches aux sections voisines. 0 la laisse comme elle est construite.</translation>
    </message>
    <message>
        <source>Bark ridge</source>
        <translation>Arête d’écorce</translation>
    </message>
    <message>
        <source>How high bark stands up above a limb where it leaves a thicker branch, as a share of that one&apos;s diameter. Twins that part at less than 30 degrees have a crease instead. 0 leaves it out.</source>
        <translation>Hauteur de l’écorce qui se dresse au-dessus d’une branche latérale là où elle quitte une branche plus épaisse, en part du diamètre de celle-ci. Les jumelles qui se séparent à moins de 30 degrés ont un pli à la place. 0 la supprime.</translation>
    </message>
    <message>
        <source>A dense oval crown on rising, forked limbs</source>
        <translation>Une couronne ovale et dense, sur des branches fourchues qui montent</translation>
    </message>
    <message>
        <source>A broad dome of twigs in pairs</source>
        <translation>Un large dôme de rameaux par paires</translation>
    </message>
    <message>
        <source>Level sprays on a low, forked trunk</source>
        <translation>Des rameaux à plat sur un tronc bas et fourchu</translation>
    </message>
    <message>
        <source>Open rising limbs with stout twigs in pairs</source>
        <translation>Des branches claires qui montent, de gros rameaux par paires</translation>
    </message>
    <message>
        <source>A tall dome whose limbs sink and turn up at their ends</source>
        <translation>Un haut dôme dont les branches descendent et se relèvent au bout</translation>
    </message>
    <message>
        <source>Limbs in storeys with short spurs along them</source>
        <translation>Des branches par étages, couvertes de rameaux courts</translation>
    </message>
    <message>
        <source>A massive trunk under wide, winding limbs</source>
        <translation>Un tronc massif sous de larges branches sinueuses</translation>
    </message>
    <message>
        <source>A vase: limbs rise and part, and their twigs hang over</source>
        <translation>Un vase : les branches montent et s’écartent, leurs rameaux retombent</translation>
    </message>
    <message>
        <source>A low, dense and crooked crown of spurs</source>
        <translation>Une couronne basse, dense et tordue de rameaux courts</translation>
    </message>
    <message>
        <source>A straight trunk with stout spreading limbs</source>
        <translation>Un tronc droit aux grosses branches étalées</translation>
    </message>
    <message>
        <source>Wider than high, with long limbs that wander</source>
        <translation>Plus large que haut, aux longues branches sinueuses</translation>
    </message>
    <message>
        <source>A massive trunk under a rounded crown</source>
        <translation>Un tronc massif sous une couronne arrondie</translation>
    </message>
    <message>
        <source>A straight trunk to the top of a tall crown</source>
        <translation>Un tronc droit jusqu’au sommet d’une haute couronne</translation>
    </message>
    <message>
        <source>A straight trunk with limbs that get shorter upwards</source>
        <translation>Un tronc droit aux branches de plus en plus courtes vers le haut</translation>
    </message>
    <message>
        <source>Crooked rising limbs in a narrow, open crown</source>
        <translation>Des branches tordues qui montent, une couronne étroite et claire</translation>
    </message>
    <message>
        <source>A small crown of rising limbs</source>
        <translation>Une petite couronne de branches qui montent</translation>
    </message>
    <message>
        <source>Many fine rising limbs, dense nearly to the ground</source>
        <translation>De nombreuses branches fines qui montent, denses presque jusqu’au sol</translation>
    </message>
    <message>
        <source>A slender cone around a trunk that reaches its top</source>
        <translation>Un cône élancé autour d’un tronc qui va jusqu’au sommet</translation>
    </message>
    <message>
        <source>Stout limbs under a broad crown</source>
        <translation>De grosses branches sous une large couronne</translation>
    </message>
    <message>
        <source>Stiff rising limbs studded with spurs</source>
        <translation>Des branches raides qui montent, hérissées de rameaux courts</translation>
    </message>
    <message>
        <source>A light cone whose twigs hang from level limbs</source>
        <translation>Un cône léger dont les rameaux pendent de branches horizontales</translation>
    </message>
    <message>
        <source>Whorls of level limbs that end in plumes</source>
        <translation>Des verticilles de branches horizontales terminées en plumes</translation>
    </message>
    <message>
        <source>A stiff blue cone of whorled limbs</source>
        <translation>Un cône bleu et raide de branches verticillées</translation>
    </message>
    <message>
        <source>A cone of level limbs with hanging tips</source>
        <translation>Un cône de branches horizontales aux bouts pendants</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>Mean wind in metres per second while the tree grows: 2 in a sheltered garden, 5 in open country, 8 on a coast, 12 on a ridge. Buds on the windward side dry out, shoots turn to leeward, and the tree stays low.</source>
        <translation>Vent moyen en mètres par seconde pendant que l’arbre pousse : 2 dans un jardin abrité, 5 en rase campagne, 8 sur une côte, 12 sur une crête. Les bourgeons exposés se dessèchent, les pousses se tournent sous le vent et l’arbre reste bas.</translation>
    </message>
    <message>
        <source>Prevailing wind</source>
        <translation>Vent dominant</translation>
    </message>
    <message>
        <source>Direction that the wind blows to in most years, as a turn about the vertical axis: 0 along X, a quarter turn against Z.</source>
        <translation>Direction vers laquelle le vent souffle la plupart des années, en rotation autour de l’axe vertical : 0 le long de X, un quart de tour contre Z.</translation>
    </message>
    <message>
        <source>Light from one side</source>
        <translation>Lumière d’un seul côté</translation>
    </message>
    <message>
        <source>0: light comes from all around. 1: from one side only, as at the edge of a wood or before a wall.</source>
        <translation>0 : la lumière vient de tous les côtés. 1 : d’un seul, comme à la lisière d’un bois ou devant un mur.</translation>
    </message>
    <message>
        <source>Side of the light</source>
        <translation>Côté de la lumière</translation>
    </message>
    <message>
        <source>The side that the light comes from, as a turn about the vertical axis: 0 along X, a quarter turn against Z.</source>
        <translation>Le côté d’où vient la lumière, en rotation autour de l’axe vertical : 0 le long de X, un quart de tour contre Z.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
    <message>
        <source>Downhill</source>
        <translation>Aval</translation>
    </message>
    <message>
        <source>Direction in which the ground falls, as a turn about the vertical axis: 0 along X, a quarter turn against Z.</source>
        <translation>Direction dans laquelle le sol descend, en rotation autour de l’axe vertical : 0 le long de X, un quart de tour contre Z.</translation>
    </message>
    <message>
        <source>Lean at the ground</source>
        <translation>Inclinaison au pied</translation>
    </message>
    <message>
        <source>How far the seedling leans downhill. Later years&apos; shoots turn up again, which leaves a curved foot.</source>
        <translation>De combien la jeune plante penche vers l’aval. Les pousses des années suivantes se redressent, ce qui laisse un pied courbé.</translation>
    </message>
    <message>
        <source>An old hawthorn on a cliff, combed by the sea wind, in autumn</source>
        <translation>Une vieille aubépine sur une falaise, peignée par le vent de mer, en automne</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Voisins</translation>
    </message>
    <message>
        <source>Other growing trees of the scene shade this one. All were planted in the same year, and each keeps the space that is nearer to its own stem.</source>
        <translation>Les autres arbres de la scène qui poussent ombragent celui-ci. Tous ont été plantés la même année, et chacun garde l’espace plus proche de sa propre tige.</translation>
    </message>
    <message>
        <source>a tree that is bare to all its ends is dead</source>
        <translation>un arbre nu jusqu’à toutes ses extrémités est mort</translation>
    </message>
    <message>
        <source>How much shoots turn to where the light comes from; how much the stem of a palm bends to it and away from solids.</source>
        <translation>Combien les pousses se tournent d’où vient la lumière ; combien le stipe d’un palmier s’y courbe, loin des solides.</translation>
    </message>
    <message>
        <source>the palm has died of it: its only bud is gone</source>
        <translation>le palmier en est mort : son seul bourgeon a disparu</translation>
    </message>
    <message>
        <source>a palm has no other buds: it gets older by its age</source>
        <translation>un palmier n’a pas d’autre bourgeon : il vieillit par son âge</translation>
    </message>
    <message>
        <source>Leaf length</source>
        <translation>Longueur des feuilles</translation>
    </message>
    <message>
        <source>Leaves per shoot</source>
        <translation>Feuilles par pousse</translation>
    </message>
    <message>
        <source>1: every leaf stands on a branch. More: in its place there is a short shoot with so many leaves, which sways as one.</source>
        <translation>1 : chaque feuille est sur une branche. Davantage : à sa place se trouve une courte pousse qui porte autant de feuilles et se balance d’un bloc.</translation>
    </message>
    <message>
        <source>Multiplies the length of all leaves; 0 leaves the twigs bare.</source>
        <translation>Multiplie la longueur de toutes les feuilles ; 0 laisse les rameaux nus.</translation>
    </message>
    <message>
        <source>Length of a leaf of the mean size, without its petiole; of needles, that of the shoot which carries them. Longer leaves stand farther apart: see Internode. 0: the leaves grow with the radius of the trunk.</source>
        <translation>Longueur d’une feuille de taille moyenne, sans son pétiole ; pour les aiguilles, celle de la pousse qui les porte. Des feuilles plus longues sont plus espacées : voir Entre-nœud. 0 : les feuilles grandissent avec le rayon du tronc.</translation>
    </message>
    <message>
        <source>Depth of the earth</source>
        <translation>Profondeur de la terre</translation>
    </message>
    <message>
        <source>How far the block of earth goes down below the lowest place of the ground. 0: a sheet without sides.</source>
        <translation>De combien le bloc de terre descend sous le point le plus bas du sol. 0 : une feuille sans côtés.</translation>
    </message>
    <message>
        <source>How steep the ground is. Limbs keep above it, roots follow it, and the crown grows to the open side, downhill.</source>
        <translation>La raideur du sol. Les branches restent au-dessus, les racines la suivent et le houppier pousse du côté dégagé, vers l’aval.</translation>
    </message>
    <message>
        <source>Standing dead wood</source>
        <translation>Bois mort sur pied</translation>
    </message>
    <message>
        <source>How long branches stand that died in the shade. 0: they fall at once. 1: twigs stay three years, a limb of 10 cm thirteen, and break off from their ends.</source>
        <translation>Combien de temps restent les branches mortes à l’ombre. 0 : elles tombent aussitôt. 1 : les rameaux restent trois ans, une branche de 10 cm treize, et elles se brisent par le bout.</translation>
    </message>
    <message>
        <source>the picture is damaged: %1</source>
        <translation>l’image est abîmée : %1</translation>
    </message>
    <message>
        <source>this picture cannot be opened</source>
        <translation>cette image ne s’ouvre pas</translation>
    </message>
    <message>
        <source>this is neither a Radiance HDR nor an OpenEXR picture</source>
        <translation>ce n’est une image ni Radiance HDR ni OpenEXR</translation>
    </message>
    <message>
        <source>row %1, column %2 is not a number</source>
        <translation>ligne %1, colonne %2 : ce n’est pas un nombre</translation>
    </message>
    <message>
        <source>the picture is damaged: it ends in row %1</source>
        <translation>l’image est abîmée : elle s’arrête à la ligne %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;-Y height +X width&quot; expected</source>
        <translation>« %1 » : « -Y hauteur +X largeur » attendu</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;FORMAT=32-bit_rle_rgbe&quot; expected</source>
        <translation>« %1 » : « FORMAT=32-bit_rle_rgbe » attendu</translation>
    </message>
    <message>
        <source>the picture is damaged: its header has no end</source>
        <translation>l’image est abîmée : son en-tête ne finit pas</translation>
    </message>
    <message>
        <source>%1 x %2 pixels: a picture all around is twice as wide as high</source>
        <translation>%1 x %2 pixels : une image tout autour est deux fois plus large que haute</translation>
    </message>
    <message>
        <source>%1 pixels wide: a picture all around has %2 to %3</source>
        <translation>%1 pixels de large : une image tout autour en a de %2 à %3</translation>
    </message>
    <message>
        <source>the picture is black</source>
        <translation>l’image est noire</translation>
    </message>
    <message>
        <source>Day of the year</source>
        <translation>Jour de l’année</translation>
    </message>
    <message>
        <source>Buds swell and burst, leaves unfold, turn and fall on the days on which those of the plant do in its climate; flowers and fruit have theirs. Colours come from pigments. 0: no day, and Season counts.</source>
        <translation>Les bourgeons gonflent et éclatent, les feuilles se déplient, virent et tombent aux jours où celles de la plante le font sous son climat ; fleurs et fruits ont les leurs. Les couleurs viennent de pigments. 0 : aucun jour, et la saison compte.</translation>
    </message>
    <message>
        <source>Climate</source>
        <translation>Climat</translation>
    </message>
    <message>
        <source>Whose winter and summer the day of the year goes by. Oceanic: as in Rennes; continental: as in Cracow; boreal: as in Jyväskylä, with a late spring and an early autumn.</source>
        <translation>Celui dont l’hiver et l’été règlent le jour de l’année. Océanique : comme à Rennes ; continental : comme à Cracovie ; boréal : comme à Jyväskylä, avec un printemps tardif et un automne précoce.</translation>
    </message>
    <message>
        <source>Purple leaves</source>
        <translation>Feuilles pourpres</translation>
    </message>
    <message>
        <source>On a day of the year: leaves are dark red all summer, as those of a copper beech.</source>
        <translation>Un jour de l’année : les feuilles sont rouge sombre tout l’été, comme celles d’un hêtre pourpre.</translation>
    </message>
    <message>
        <source>Where there is no day of the year. 0 is summer. Then leaves take the colour of their plant&apos;s autumn, the upper ones first, and fall, until at 100 % the twigs are bare. Evergreens stay as they are.</source>
        <translation>Là où il n’y a pas de jour de l’année. 0 est l’été. Puis les feuilles prennent la couleur d’automne de leur plante, celles du haut d’abord, et tombent, jusqu’à ce qu’à 100 % les rameaux soient nus. Les arbres à feuilles persistantes restent tels quels.</translation>
    </message>
    <message>
        <source>Oceanic</source>
        <translation>Océanique</translation>
    </message>
    <message>
        <source>Continental</source>
        <translation>Continental</translation>
    </message>
    <message>
        <source>Boreal</source>
        <translation>Boréal</translation>
    </message>
    <message>
        <source>Four seasons</source>
        <translation>Quatre saisons</translation>
    </message>
    <message>
        <source>One file for a year: materials for spring, summer, autumn and winter, which engines and web viewers can choose from. Shaders that want any day in between find a number at each leaf that says when it turns.</source>
        <translation>Un fichier pour une année : des matériaux de printemps, d’été, d’automne et d’hiver, que les moteurs et les pages web peuvent choisir. Les shaders qui veulent un jour entre les deux trouvent à chaque feuille un nombre qui dit quand elle vire.</translation>
    </message>
    <message>
        <source>variants of the seasons are those of a tree at rest, or without a day</source>
        <translation>les variantes des saisons sont celles d’un arbre au repos, ou sans jour</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Roulis</translation>
    </message>
    <message>
        <source>there is nothing above the roll</source>
        <translation>il n’y a rien au-dessus du roulis</translation>
    </message>
    <message>
        <source>Shade leaves</source>
        <translation>Feuilles d’ombre</translation>
    </message>
    <message>
        <source>Area of a leaf inside the crown, where it is dark, relative to one in full sun: 1 the same, in nature 1.3 to 1.8. Shade leaves are darker, too.</source>
        <translation>Surface d’une feuille à l’intérieur du houppier, où il fait sombre, par rapport à une feuille en plein soleil : 1 la même, dans la nature 1,3 à 1,8. Les feuilles d’ombre sont aussi plus foncées.</translation>
    </message>
    <message>
        <source>Damaged leaves</source>
        <translation>Feuilles abîmées</translation>
    </message>
    <message>
        <source>Share of the leaves that insects, fungi or drought have marked: they are smaller and have withered in part.</source>
        <translation>Part des feuilles que des insectes, des champignons ou la sécheresse ont marquées : elles sont plus petites et en partie flétries.</translation>
    </message>
    <message>
        <source>Fruit diameter</source>
        <translation>Diamètre des fruits</translation>
    </message>
    <message>
        <source>Diameter of a fruit or flower of the mean size, at its widest. 0: fruit grow with the radius of the trunk.</source>
        <translation>Diamètre d’un fruit ou d’une fleur de taille moyenne, au plus large. 0 : les fruits suivent le rayon du tronc.</translation>
    </message>
    <message>
        <source>Multiplies the diameter of all fruit; 0 leaves the tree without.</source>
        <translation>Multiplie le diamètre de tous les fruits ; 0 n’en laisse aucun à l’arbre.</translation>
    </message>
    <message>
        <source>Fruit per cluster</source>
        <translation>Fruits par grappe</translation>
    </message>
    <message>
        <source>How many fruit or flowers hang from one place: 0 as the plant has it.</source>
        <translation>Nombre de fruits ou de fleurs pendus au même endroit : 0 comme la plante le veut.</translation>
    </message>
    <message>
        <source>Ripe fruit</source>
        <translation>Fruits mûrs</translation>
    </message>
    <message>
        <source>At 100 % all fruit have their last colour; below, some are still green, each as far as its place and chance let it.</source>
        <translation>À 100 %, tous les fruits ont leur dernière couleur ; en dessous, certains sont encore verts, chacun selon sa place et le hasard.</translation>
    </message>
    <message>
        <source>Six recipes</source>
        <translation>Six recettes</translation>
    </message>
    <message>
        <source>films are written as .mp4 or .webm</source>
        <translation>les films s’écrivent en .mp4 ou .webm</translation>
    </message>
    <message>
        <source>films need the program ffmpeg, which is not installed; pictures are written without it, as .png</source>
        <translation>les films demandent le programme ffmpeg, qui n’est pas installé ; les images s’écrivent sans lui, en .png</translation>
    </message>
    <message>
        <source>ffmpeg cannot encode the film: %1</source>
        <translation>ffmpeg ne peut pas encoder le film : %1</translation>
    </message>
    <message>
        <source>no temporary file can be made: %1</source>
        <translation>aucun fichier temporaire ne peut être créé : %1</translation>
    </message>
    <message>
        <source>all pictures of a film have one size</source>
        <translation>toutes les images d’un film ont la même taille</translation>
    </message>
    <message>
        <source>the encoded film cannot be read: %1</source>
        <translation>le film encodé ne peut pas être lu : %1</translation>
    </message>
    <message>
        <source>levels of detail have the leaves of one day: write the four seasons without levels, or one file of levels for each day</source>
        <translation>les niveaux de détail ont les feuilles d’un jour : écrivez les quatre saisons sans niveaux, ou un fichier de niveaux par jour</translation>
    </message>
    <message>
        <source>Red in autumn</source>
        <translation>Rouge en automne</translation>
    </message>
    <message>
        <source>On a day of the year: how red leaves turn, against those of the plant. At 0 red ones turn yellow, as a Norway maple beside a sugar maple.</source>
        <translation>À un jour de l’année : combien les feuilles rougissent, par rapport à celles de la plante. À 0, les rouges jaunissent, comme un érable plane à côté d’un érable à sucre.</translation>
    </message>
    <message>
        <source>USD</source>
        <translation>USD</translation>
    </message>
    <message>
        <source>USD, with materials, motion and variants</source>
        <translation>USD, avec matériaux, mouvement et variantes</translation>
    </message>
    <message>
        <source>USD package</source>
        <translation>Paquet USD</translation>
    </message>
    <message>
        <source>USD package (usdz), in one file</source>
        <translation>Paquet USD (usdz), en un seul fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; where a prim begins</source>
        <translation>« %1 » là où commence un prim</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a prim</source>
        <translation>« %1 » n’est pas un nom de prim</translation>
    </message>
    <message>
        <source>two prims have the name &quot;%1&quot;</source>
        <translation>deux prims portent le nom « %1 »</translation>
    </message>
    <message>
        <source>more prims than a file can have</source>
        <translation>plus de prims qu’un fichier ne peut en avoir</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no type of an attribute</source>
        <translation>« %1 » n’est pas un type d’attribut</translation>
    </message>
    <message>
        <source>the attribute &quot;%1&quot; has two types</source>
        <translation>l’attribut « %1 » a deux types</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no part of an attribute</source>
        <translation>« %1 » n’est pas une partie d’attribut</translation>
    </message>
    <message>
        <source>the attribute &quot;%1&quot; stands there twice</source>
        <translation>l’attribut « %1 » y est deux fois</translation>
    </message>
    <message>
        <source>a relationship leads to paths</source>
        <translation>une relation mène à des chemins</translation>
    </message>
    <message>
        <source>there is no prim %1</source>
        <translation>il n’y a pas de prim %1</translation>
    </message>
    <message>
        <source>the material %1 is no UsdPreviewSurface: its colour is left out</source>
        <translation>le matériau %1 n’est pas un UsdPreviewSurface : sa couleur est laissée de côté</translation>
    </message>
    <message>
        <source>only PNG, JPEG and EXR can be pictures of a USD file</source>
        <translation>seuls PNG, JPEG et EXR peuvent être des images d’un fichier USD</translation>
    </message>
    <message>
        <source>an unknown operation, or of another type</source>
        <translation>une opération inconnue, ou d’un autre type</translation>
    </message>
    <message>
        <source>a place that cannot be inverted</source>
        <translation>un emplacement qui ne peut pas être inversé</translation>
    </message>
    <message>
        <source>%1 values where there have to be %2</source>
        <translation>%1 valeurs là où il doit y en avoir %2</translation>
    </message>
    <message>
        <source>the file shows no mesh and no camera</source>
        <translation>le fichier ne montre ni maillage ni caméra</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no axis that points up</source>
        <translation>« %1 » n’est pas un axe qui pointe vers le haut</translation>
    </message>
    <message>
        <source>the unit of the file is no length</source>
        <translation>l’unité du fichier n’est pas une longueur</translation>
    </message>
    <message>
        <source>another file is not read: %1</source>
        <translation>un autre fichier n’est pas lu : %1</translation>
    </message>
    <message>
        <source>a part of a place is left out: %1</source>
        <translation>une partie d’un emplacement est laissée de côté : %1</translation>
    </message>
    <message>
        <source>meshes with a skin are read as they rest, without their joints</source>
        <translation>les maillages qui ont une peau sont lus au repos, sans leurs articulations</translation>
    </message>
    <message>
        <source>surfaces of subdivision are read as the mesh that they are made of</source>
        <translation>les surfaces de subdivision sont lues comme le maillage dont elles sont faites</translation>
    </message>
    <message>
        <source>what the file hides is left out</source>
        <translation>ce que le fichier cache est laissé de côté</translation>
    </message>
    <message>
        <source>of variants only those are taken that the file chooses</source>
        <translation>des variantes, seules celles que le fichier choisit sont prises</translation>
    </message>
    <message>
        <source>a USD file says itself which axis points up and what its unit is</source>
        <translation>un fichier USD dit lui-même quel axe pointe vers le haut et quelle est son unité</translation>
    </message>
    <message>
        <source>a binary USD file: only USD as text can be read</source>
        <translation>un fichier USD binaire : seul l’USD en texte peut être lu</translation>
    </message>
    <message>
        <source>no USD file: its first line is not &quot;#usda 1.0&quot;</source>
        <translation>pas un fichier USD : sa première ligne n’est pas « #usda 1.0 »</translation>
    </message>
    <message>
        <source>%1 where &quot;%2&quot; has to stand</source>
        <translation>%1 là où « %2 » doit être</translation>
    </message>
    <message>
        <source>%1 where a word has to stand</source>
        <translation>%1 là où doit être un mot</translation>
    </message>
    <message>
        <source>%1 where a name has to stand</source>
        <translation>%1 là où doit être un nom</translation>
    </message>
    <message>
        <source>%1 where a text has to stand</source>
        <translation>%1 là où doit être un texte</translation>
    </message>
    <message>
        <source>a text without an end</source>
        <translation>un texte sans fin</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>%1 where a number has to stand</source>
        <translation>%1 là où doit être un nombre</translation>
    </message>
    <message>
        <source>more numbers than a file can hold</source>
        <translation>plus de nombres qu’un fichier ne peut en contenir</translation>
    </message>
    <message>
        <source>%1 numbers where %2 have to stand</source>
        <translation>%1 nombres là où il en faut %2</translation>
    </message>
    <message>
        <source>a path of a file without an end</source>
        <translation>un chemin de fichier sans fin</translation>
    </message>
    <message>
        <source>a path without an end</source>
        <translation>un chemin sans fin</translation>
    </message>
    <message>
        <source>too many brackets</source>
        <translation>trop de parenthèses</translation>
    </message>
    <message>
        <source>a face of %1 corners</source>
        <translation>une face de %1 sommets</translation>
    </message>
    <message>
        <source>a list of the type %1</source>
        <translation>une liste du type %1</translation>
    </message>
    <message>
        <source>a number that is too large</source>
        <translation>un nombre trop grand</translation>
    </message>
    <message>
        <source>index %1 of %2</source>
        <translation>indice %1 sur %2</translation>
    </message>
    <message>
        <source>the picture &quot;%1&quot; is not there</source>
        <translation>l’image « %1 » n’y est pas</translation>
    </message>
    <message>
        <source>PC2 point cache</source>
        <translation>Cache de points PC2</translation>
    </message>
    <message>
        <source>PC2, points in motion, with an OBJ</source>
        <translation>PC2, points en mouvement, avec un OBJ</translation>
    </message>
    <message>
        <source>only a tree that grows by years and branches can grow as one mesh</source>
        <translation>seul un arbre qui pousse année par année et se ramifie peut pousser en un seul maillage</translation>
    </message>
    <message>
        <source>the step &quot;%1&quot; is not part of the tree&apos;s life: it cannot grow with it</source>
        <translation>l’étape « %1 » ne fait pas partie de la vie de l’arbre : elle ne peut pas pousser avec lui</translation>
    </message>
    <message>
        <source>2 to %1 key shapes expected</source>
        <translation>de 2 à %1 formes clés attendues</translation>
    </message>
    <message>
        <source>the growth begins at 0.25 years or later, and before the tree&apos;s own age</source>
        <translation>la croissance commence à 0,25 an ou plus tard, et avant l’âge de l’arbre</translation>
    </message>
    <message>
        <source>nothing has grown</source>
        <translation>rien n’a poussé</translation>
    </message>
    <message>
        <source>None: it has its age</source>
        <translation>Aucune : il a son âge</translation>
    </message>
    <message>
        <source>From the first year on</source>
        <translation>À partir de la première année</translation>
    </message>
    <message>
        <source>A tree that grows by years, as one mesh that grows from its first year to its age when it plays: the same vertices and triangles at every age, with key shapes (morph targets) between which engines mix. Leaves open and close at each key shape.</source>
        <translation>Un arbre qui pousse année par année, en un seul maillage qui pousse en jouant de sa première année à son âge : les mêmes sommets et triangles à tout âge, avec des formes clés (morph targets) que les moteurs mélangent. Les feuilles s’ouvrent et se ferment à chaque forme clé.</translation>
    </message>
    <message>
        <source>%1 key shapes: between two of them no living branch is more than %2 m from its place</source>
        <translation>%1 formes clés : entre deux d’entre elles, aucune branche vivante n’est à plus de %2 m de sa place</translation>
    </message>
    <message>
        <source>this format cannot hold a tree that grows as one mesh</source>
        <translation>ce format ne peut pas contenir un arbre qui pousse en un seul maillage</translation>
    </message>
    <message>
        <source>only the finished mesh can grow as one mesh</source>
        <translation>seul le maillage fini peut pousser en un seul maillage</translation>
    </message>
    <message>
        <source>a tree that grows as one mesh has no levels, instances, seasons, wind or clip besides</source>
        <translation>un arbre qui pousse en un seul maillage n’a en plus ni niveaux, ni instances, ni saisons, ni vent, ni animation</translation>
    </message>
    <message>
        <source>the file shows no mesh of its own, only those of other files: %1</source>
        <translation>le fichier ne montre aucun maillage à lui, seulement ceux d’autres fichiers : %1</translation>
    </message>
    <message>
        <source>a %1 is no mesh: it is left out</source>
        <translation>%1 n’est pas un maillage : il est laissé de côté</translation>
    </message>
    <message>
        <source>a shape without a size</source>
        <translation>une forme sans taille</translation>
    </message>
    <message>
        <source>the picture of cards has %1 to %2 pixels a side, a power of two, not %3</source>
        <translation>l’image des cartes a de %1 à %2 pixels de côté, une puissance de deux, et non %3</translation>
    </message>
    <message>
        <source>a tree of nothing has no billboard</source>
        <translation>un arbre de rien n’a pas de billboard</translation>
    </message>
    <message>
        <source>Unreal Engine</source>
        <translation>Unreal Engine</translation>
    </message>
    <message>
        <source>Godot</source>
        <translation>Godot</translation>
    </message>
    <message>
        <source>Collision for</source>
        <translation>Collision pour</translation>
    </message>
    <message>
        <source>Adds convex pieces around the trunk and thick limbs, under the names by which the engine takes them for what bodies bump into.</source>
        <translation>Ajoute des pièces convexes autour du tronc et des grosses branches, sous les noms auxquels le moteur reconnaît ce que heurtent les corps.</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 ne peut pas être lancé : %2</translation>
    </message>
    <message>
        <source>FBX is written by Blender, which is not installed: install it, or write a GLB</source>
        <translation>le FBX est écrit par Blender, qui n’est pas installé : installez-le, ou écrivez un GLB</translation>
    </message>
    <message>
        <source>no temporary folder can be made</source>
        <translation>aucun dossier temporaire ne peut être créé</translation>
    </message>
    <message>
        <source>Blender cannot write the FBX: %1</source>
        <translation>Blender ne peut pas écrire le FBX : %1</translation>
    </message>
    <message>
        <source>FBX, by Blender</source>
        <translation>FBX, par Blender</translation>
    </message>
    <message>
        <source>FBX, written by Blender where it is installed</source>
        <translation>FBX, écrit par Blender là où il est installé</translation>
    </message>
    <message>
        <source>a folder for an engine holds the finished mesh of a tree at rest, with its pictures and merged leaves</source>
        <translation>un dossier pour un moteur contient le maillage fini d’un arbre au repos, avec ses images et ses feuilles fusionnées</translation>
    </message>
    <message>
        <source>a folder for an engine holds one tree, and nothing else</source>
        <translation>un dossier pour un moteur contient un arbre, et rien d’autre</translation>
    </message>
    <message>
        <source>Unity</source>
        <translation>Unity</translation>
    </message>
    <message>
        <source>A massive column under a narrow crown of upturned limbs</source>
        <translation>Une colonne massive sous une cime étroite aux branches redressées</translation>
    </message>
    <message>
        <source>A broad dark dome, dense to the ground</source>
        <translation>Un large dôme sombre, dense jusqu&apos;au sol</translation>
    </message>
    <message>
        <source>A tall crown in clouds on winding limbs</source>
        <translation>Une haute cime en nuages sur des branches sinueuses</translation>
    </message>
    <message>
        <source>row %1 has a pixel that is no finite number</source>
        <translation>la ligne %1 a un pixel qui n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>this is neither a PNG nor an OpenEXR picture</source>
        <translation>ce n’est ni une image PNG ni une image OpenEXR</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Semis</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Instances</translation>
    </message>
    <message>
        <source>At most so many copies of the nodes below stand on the ground. 0: as many as the spacing lets stand.</source>
        <translation>Nombre maximal de copies des nœuds du dessous qui se dressent sur le sol. 0 : autant que l’espacement le permet.</translation>
    </message>
    <message>
        <source>Two copies stand at least so far apart, measured on a map.</source>
        <translation>Distance minimale entre deux copies, mesurée sur une carte.</translation>
    </message>
    <message>
        <source>Seed of the places</source>
        <translation>Graine des places</translation>
    </message>
    <message>
        <source>Another seed gives other places, turns and sizes. The same seed always gives the same.</source>
        <translation>Une autre graine donne d’autres places, orientations et tailles. La même graine donne toujours la même chose.</translation>
    </message>
    <message>
        <source>Width of the area</source>
        <translation>Largeur de la surface</translation>
    </message>
    <message>
        <source>How far the area reaches along X, with the node in its middle.</source>
        <translation>Étendue de la surface le long de X, le nœud en son milieu.</translation>
    </message>
    <message>
        <source>Depth of the area</source>
        <translation>Profondeur de la surface</translation>
    </message>
    <message>
        <source>How far the area reaches along Z, with the node in its middle.</source>
        <translation>Étendue de la surface le long de Z, le nœud en son milieu.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Name of the node that the copies stand on: a terrain, a mesh or a shape. If it is empty, they stand on all terrains of the scene, and on the level ground where there is none.</source>
        <translation>Nom du nœud sur lequel les copies se dressent : un terrain, un maillage ou une forme. S’il est vide, elles se dressent sur tous les terrains de la scène, et sur le sol plat s’il n’y en a pas.</translation>
    </message>
    <message>
        <source>Map of density</source>
        <translation>Carte de densité</translation>
    </message>
    <message>
        <source>A picture that lies over the area as seen from above, its lower edge at the greater Z: where it is white, copies stand as densely as they may; where it is black, none stand.</source>
        <translation>Une image posée sur la surface vue d’en haut, son bord inférieur du côté des grands Z : là où elle est blanche, les copies sont aussi denses que possible ; là où elle est noire, il n’y en a aucune.</translation>
    </message>
    <message>
        <source>Steepest slope</source>
        <translation>Pente maximale</translation>
    </message>
    <message>
        <source>No copy stands where the ground is steeper than this.</source>
        <translation>Aucune copie ne se dresse là où le sol est plus raide.</translation>
    </message>
    <message>
        <source>Lowest ground</source>
        <translation>Sol le plus bas</translation>
    </message>
    <message>
        <source>No copy stands on ground that lies lower than this, from the scatter&apos;s own height.</source>
        <translation>Aucune copie ne se dresse sur un sol plus bas que cela, à partir de la hauteur du semis.</translation>
    </message>
    <message>
        <source>Highest ground</source>
        <translation>Sol le plus haut</translation>
    </message>
    <message>
        <source>No copy stands on ground that lies higher than this, from the scatter&apos;s own height.</source>
        <translation>Aucune copie ne se dresse sur un sol plus haut que cela, à partir de la hauteur du semis.</translation>
    </message>
    <message>
        <source>Distance from obstacles</source>
        <translation>Distance aux obstacles</translation>
    </message>
    <message>
        <source>How far copies keep away from shapes and meshes whose role for trees is “Obstacle”, measured on a map. None stands on such a solid.</source>
        <translation>Distance que les copies gardent, mesurée sur une carte, aux formes et aux maillages dont le rôle pour les arbres est « Obstacle ». Aucune ne se dresse sur un tel solide.</translation>
    </message>
    <message>
        <source>Clusters</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>How strongly copies gather in clusters: 0 spreads them evenly, 1 leaves clearings empty.</source>
        <translation>À quel point les copies se groupent : 0 les répartit également, 1 laisse les clairières vides.</translation>
    </message>
    <message>
        <source>Size of clusters</source>
        <translation>Taille des groupes</translation>
    </message>
    <message>
        <source>How wide a cluster is.</source>
        <translation>Largeur d’un groupe.</translation>
    </message>
    <message>
        <source>Shares</source>
        <translation>Parts</translation>
    </message>
    <message>
        <source>How often each of the nodes below is taken, in their order: “3 1” takes the first three times as often as the second. A node without a number has 1.</source>
        <translation>Fréquence de chacun des nœuds du dessous, dans leur ordre : « 3 1 » prend le premier trois fois plus souvent que le second. Un nœud sans nombre a 1.</translation>
    </message>
    <message>
        <source>Smallest scale</source>
        <translation>Plus petite échelle</translation>
    </message>
    <message>
        <source>How small the smallest copy is, compared with the node that it copies.</source>
        <translation>Taille de la plus petite copie par rapport au nœud qu’elle copie.</translation>
    </message>
    <message>
        <source>Largest scale</source>
        <translation>Plus grande échelle</translation>
    </message>
    <message>
        <source>How large the largest copy is, compared with the node that it copies.</source>
        <translation>Taille de la plus grande copie par rapport au nœud qu’elle copie.</translation>
    </message>
    <message>
        <source>Turned by chance</source>
        <translation>Tournées au hasard</translation>
    </message>
    <message>
        <source>How far copies are turned about the vertical: 0 not at all, 1 by any angle.</source>
        <translation>De combien les copies sont tournées autour de la verticale : 0 pas du tout, 1 d’un angle quelconque.</translation>
    </message>
    <message>
        <source>Along the slope</source>
        <translation>Selon la pente</translation>
    </message>
    <message>
        <source>How far copies lean with the ground: 0 stands upright, as trees do, 1 square to the ground, as stones lie.</source>
        <translation>De combien les copies penchent avec le sol : 0 droites, comme les arbres, 1 perpendiculaires au sol, comme les pierres.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Retirées</translation>
    </message>
    <message>
        <source>Keys of copies that were taken away by hand, or made trees of their own. Empty it to have them all back.</source>
        <translation>Clés des copies retirées à la main ou devenues des arbres à part entière. Videz ce texte pour les retrouver toutes.</translation>
    </message>
    <message>
        <source>“%1” is no number that is possible here</source>
        <translation>« %1 » n’est pas un nombre possible ici</translation>
    </message>
    <message>
        <source>no node below the scatter has a share above 0</source>
        <translation>aucun nœud sous le semis n’a une part supérieure à 0</translation>
    </message>
    <message>
        <source>over %1 instances: the spacing is too small for this area</source>
        <translation>plus de %1 instances : l’espacement est trop petit pour cette surface</translation>
    </message>
    <message>
        <source>a scatter without a spacing needs a number of instances</source>
        <translation>un semis sans espacement a besoin d’un nombre d’instances</translation>
    </message>
    <message>
        <source>there is no node “%1” to stand on</source>
        <translation>il n’y a pas de nœud « %1 » sur lequel se dresser</translation>
    </message>
    <message>
        <source>“%1” has no surface to stand on</source>
        <translation>« %1 » n’a pas de surface sur laquelle se dresser</translation>
    </message>
    <message>
        <source>“%1” is itself copied by a scatter: nothing can stand on it</source>
        <translation>« %1 » est lui-même copié par un semis : rien ne peut s’y dresser</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>semis</translation>
    </message>
    <message>
        <source>Scatter: %1</source>
        <translation>Semis : %1</translation>
    </message>
    <message>
        <source>&amp;Scatter</source>
        <translation>&amp;Semis</translation>
    </message>
    <message>
        <source>Add a scatter: many copies of the selected trees and shapes stand on the ground</source>
        <translation>Ajouter un semis : de nombreuses copies des arbres et des formes sélectionnés se dressent sur le sol</translation>
    </message>
    <message>
        <source>Marks of the bark</source>
        <translation>Marques de l’écorce</translation>
    </message>
    <message>
        <source>Scars</source>
        <translation>Cicatrices</translation>
    </message>
    <message>
        <source>How many of the limbs that fell or were cut leave a scar, if they were thicker than 2 cm. Bark rolls over the wound as the wood thickens, and the eye that is left flattens out. A triangle budget leaves out the smallest.</source>
        <translation>Combien des branches tombées ou coupées laissent une cicatrice, si elles avaient plus de 2 cm d’épaisseur. L’écorce recouvre la plaie en bourrelet à mesure que le bois s’épaissit, et l’œil qui reste s’aplatit. Un budget de triangles laisse de côté les plus petites.</translation>
    </message>
    <message>
        <source>Hollows</source>
        <translation>Cavités</translation>
    </message>
    <message>
        <source>How many of the scars over 8 cm have rotted into a hollow, which never closes.</source>
        <translation>Combien des cicatrices de plus de 8 cm ont pourri en une cavité, qui ne se referme jamais.</translation>
    </message>
    <message>
        <source>Burrs</source>
        <translation>Loupes</translation>
    </message>
    <message>
        <source>How many burrs swell on ten metres of the trunk and of limbs, as on old oaks, lindens and walnuts.</source>
        <translation>Combien de loupes gonflent sur dix mètres de tronc et de branches, comme sur les vieux chênes, tilleuls et noyers.</translation>
    </message>
    <message>
        <source>Splinters</source>
        <translation>Esquilles</translation>
    </message>
    <message>
        <source>How far splinters stand out of the broken ends of dead limbs, in diameters of the wood. 0: ends are flat, as those of living wood that was cut.</source>
        <translation>De combien les esquilles dépassent des extrémités cassées des branches mortes, en diamètres du bois. 0 : les extrémités sont plates, comme celles du bois vivant que l’on a coupé.</translation>
    </message>
    <message>
        <source>place %1 of a crowd is none</source>
        <translation>l’emplacement %1 d’une foule n’en est pas un</translation>
    </message>
    <message>
        <source>the picture has no channels</source>
        <translation>l’image n’a pas de canaux</translation>
    </message>
    <message>
        <source>Picture of heights</source>
        <translation>Image de hauteurs</translation>
    </message>
    <message>
        <source>Grows as a stand</source>
        <translation>Pousse en peuplement</translation>
    </message>
    <message>
        <source>The trees are sown at their places and grow up together: they take each other&apos;s light, most of them die of shade, and the others are as high as trees of their age in a stand. Of several prototypes of one species each tree takes the one that is most nearly as high.</source>
        <translation>Les arbres sont semés à leurs places et poussent ensemble : ils se prennent la lumière, la plupart meurent à l’ombre, et les autres sont aussi hauts que des arbres de leur âge en peuplement. De plusieurs prototypes d’une espèce, chaque arbre prend celui dont la hauteur est la plus proche.</translation>
    </message>
    <message>
        <source>Age of the stand</source>
        <translation>Âge du peuplement</translation>
    </message>
    <message>
        <source>How long ago its trees were sown.</source>
        <translation>Il y a combien de temps ses arbres ont été semés.</translation>
    </message>
    <message>
        <source>“%1” is nothing that a scatter can copy</source>
        <translation>« %1 » n’est rien qu’un semis puisse copier</translation>
    </message>
    <message>
        <source>the scatter has no such copy</source>
        <translation>le semis n’a pas de telle copie</translation>
    </message>
    <message>
        <source>%1 copies of %2 would be a mesh of %3 million triangles: write instances, or choose a format that has them (GLB, USD)</source>
        <translation>%1 copies de %2 feraient un maillage de %3 millions de triangles : écrivez des instances, ou choisissez un format qui en a (GLB, USD)</translation>
    </message>
    <message>
        <source>copies of a scatter are written as meshes alone</source>
        <translation>les copies d’un semis s’écrivent seulement comme maillages</translation>
    </message>
    <message>
        <source>copies of a scatter do not move: write one moment</source>
        <translation>les copies d’un semis ne bougent pas : écrivez un seul instant</translation>
    </message>
    <message>
        <source>copies of a scatter have no levels of detail: write its trees by themselves</source>
        <translation>les copies d’un semis n’ont pas de niveaux de détail : écrivez ses arbres à part</translation>
    </message>
    <message>
        <source>copies of a scatter do not grow: write its trees by themselves</source>
        <translation>les copies d’un semis ne poussent pas : écrivez ses arbres à part</translation>
    </message>
    <message>
        <source>copies of a scatter have no data for wind: write its trees by themselves</source>
        <translation>les copies d’un semis n’ont pas de données pour le vent : écrivez ses arbres à part</translation>
    </message>
    <message>
        <source>there is nothing to copy yet: drag trees or shapes below the scatter</source>
        <translation>il n’y a encore rien à copier : glissez des arbres ou des formes sous le semis</translation>
    </message>
    <message>
        <source>a stand has trees, and an age of 1 to 400 years</source>
        <translation>un peuplement a des arbres, et un âge de 1 à 400 ans</translation>
    </message>
    <message>
        <source>a stand is sown with %1 trees at most</source>
        <translation>un peuplement compte %1 arbres semés au plus</translation>
    </message>
    <message>
        <source>a stand reaches %1 m from its middle at most</source>
        <translation>un peuplement s’étend à %1 m de son milieu au plus</translation>
    </message>
</context>
<context>
    <name>keys</name>
    <message>
        <source>Insert &amp;only</source>
        <translation>Insérer &amp;seulement</translation>
    </message>
    <message>
        <source>Select &amp;keys</source>
        <translation>Séle&amp;ctionner des clés</translation>
    </message>
    <message>
        <source>In&amp;terpolation</source>
        <translation>In&amp;terpolation</translation>
    </message>
    <message>
        <source>E&amp;asing</source>
        <translation>&amp;Accélération</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>Poi&amp;gnées</translation>
    </message>
    <message>
        <source>E&amp;xtrapolation</source>
        <translation>E&amp;xtrapolation</translation>
    </message>
    <message>
        <source>Duplicate Keys</source>
        <translation>Dupliquer des clés</translation>
    </message>
    <message>
        <source>Insert Keys</source>
        <translation>Insérer des clés</translation>
    </message>
    <message>
        <source>Delete Keys</source>
        <translation>Supprimer des clés</translation>
    </message>
    <message>
        <source>Change Extrapolation</source>
        <translation>Changer l’extrapolation</translation>
    </message>
    <message>
        <source>Paste Keys</source>
        <translation>Coller des clés</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constant</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Bézier</source>
        <translation>Bézier</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Quadratic</source>
        <translation>Quadratique</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Cubique</translation>
    </message>
    <message>
        <source>Quartic</source>
        <translation>Quartique</translation>
    </message>
    <message>
        <source>Quintic</source>
        <translation>Quintique</translation>
    </message>
    <message>
        <source>Exponential</source>
        <translation>Exponentiel</translation>
    </message>
    <message>
        <source>Circular</source>
        <translation>Circulaire</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Recul</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Rebond</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Élastique</translation>
    </message>
    <message>
        <source>The value stays until the next key</source>
        <translation>La valeur reste jusqu’à la clé suivante</translation>
    </message>
    <message>
        <source>Straight to the next key</source>
        <translation>Tout droit jusqu’à la clé suivante</translation>
    </message>
    <message>
        <source>Along the handles of this key and the next</source>
        <translation>Suivant les poignées de cette clé et de la suivante</translation>
    </message>
    <message>
        <source>A spline through the keys around, without handles</source>
        <translation>Une spline par les clés voisines, sans poignées</translation>
    </message>
    <message>
        <source>An easing: the picture shows the way to the next key</source>
        <translation>Une accélération : l’image montre le chemin vers la clé suivante</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>At both ends</source>
        <translation>Aux deux bouts</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libres</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Alignées</translation>
    </message>
    <message>
        <source>Vector</source>
        <translation>Vectorielles</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisses</translation>
    </message>
    <message>
        <source>Smooth, never beyond the keys</source>
        <translation>Lisses, jamais au-delà des clés</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Tenir</translation>
    </message>
    <message>
        <source>Go on straight</source>
        <translation>Continuer tout droit</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Repeat with offset</source>
        <translation>Répéter avec décalage</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Aller et retour</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Joint %1: %2</source>
        <translation>Articulation %1 : %2</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rouge</translation>
    </message>
    <message>
        <source>green</source>
        <translation>vert</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>bleu</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Own position</source>
        <translation>Position propre</translation>
    </message>
    <message>
        <source>Own rotation</source>
        <translation>Rotation propre</translation>
    </message>
    <message>
        <source>Own scale</source>
        <translation>Échelle propre</translation>
    </message>
</context>
<context>
    <name>presets</name>
    <message>
        <source>American Elm</source>
        <translation>Orme d’Amérique</translation>
    </message>
    <message>
        <source>Aono Kunii Tree</source>
        <translation>Arbre d’Aono et Kunii</translation>
    </message>
    <message>
        <source>Balsam Fir</source>
        <translation>Sapin baumier</translation>
    </message>
    <message>
        <source>Bamboo</source>
        <translation>Bambou</translation>
    </message>
    <message>
        <source>Baobab</source>
        <translation>Baobab africain</translation>
    </message>
    <message>
        <source>Black Locust</source>
        <translation>Robinier faux-acacia</translation>
    </message>
    <message>
        <source>Black Tupelo</source>
        <translation>Tupélo noir</translation>
    </message>
    <message>
        <source>Blue Gum</source>
        <translation>Gommier bleu</translation>
    </message>
    <message>
        <source>Blue Spruce</source>
        <translation>Épicéa bleu</translation>
    </message>
    <message>
        <source>Bonsai</source>
        <translation>Bonsaï</translation>
    </message>
    <message>
        <source>California Black Oak</source>
        <translation>Chêne noir de Californie</translation>
    </message>
    <message>
        <source>Coast Redwood</source>
        <translation>Séquoia à feuilles d’if</translation>
    </message>
    <message>
        <source>Coconut Palm</source>
        <translation>Cocotier</translation>
    </message>
    <message>
        <source>Common Alder</source>
        <translation>Aulne glutineux</translation>
    </message>
    <message>
        <source>Common Ash</source>
        <translation>Frêne élevé</translation>
    </message>
    <message>
        <source>Common Walnut</source>
        <translation>Noyer commun</translation>
    </message>
    <message>
        <source>Common Yew</source>
        <translation>If commun</translation>
    </message>
    <message>
        <source>Date Palm</source>
        <translation>Palmier dattier</translation>
    </message>
    <message>
        <source>Dead Snag</source>
        <translation>Tronc mort</translation>
    </message>
    <message>
        <source>Deodar Cedar</source>
        <translation>Cèdre de l’Himalaya</translation>
    </message>
    <message>
        <source>Douglas Fir</source>
        <translation>Douglas vert</translation>
    </message>
    <message>
        <source>Eastern Cottonwood</source>
        <translation>Peuplier deltoïde</translation>
    </message>
    <message>
        <source>Eastern White Pine</source>
        <translation>Pin blanc d’Amérique</translation>
    </message>
    <message>
        <source>English Oak</source>
        <translation>Chêne pédonculé</translation>
    </message>
    <message>
        <source>European Beech</source>
        <translation>Hêtre commun</translation>
    </message>
    <message>
        <source>European Larch</source>
        <translation>Mélèze d’Europe</translation>
    </message>
    <message>
        <source>Fan Palm</source>
        <translation>Palmier de Californie</translation>
    </message>
    <message>
        <source>Fan Tree</source>
        <translation>Arbre en éventail</translation>
    </message>
    <message>
        <source>Fern2D</source>
        <translation>Fougère 2D</translation>
    </message>
    <message>
        <source>Field Elm</source>
        <translation>Orme champêtre</translation>
    </message>
    <message>
        <source>Giant Sequoia</source>
        <translation>Séquoia géant</translation>
    </message>
    <message>
        <source>Ginkgo</source>
        <translation>Arbre aux quarante écus</translation>
    </message>
    <message>
        <source>Hawthorn</source>
        <translation>Aubépine monogyne</translation>
    </message>
    <message>
        <source>Hedge</source>
        <translation>Haie</translation>
    </message>
    <message>
        <source>Honda Tree</source>
        <translation>Arbre de Honda</translation>
    </message>
    <message>
        <source>Honey Locust</source>
        <translation>Févier d’Amérique</translation>
    </message>
    <message>
        <source>Hornbeam</source>
        <translation>Charme commun</translation>
    </message>
    <message>
        <source>Horse Chestnut</source>
        <translation>Marronnier d’Inde</translation>
    </message>
    <message>
        <source>Italian Cypress</source>
        <translation>Cyprès d’Italie</translation>
    </message>
    <message>
        <source>Jacaranda</source>
        <translation>Flamboyant bleu</translation>
    </message>
    <message>
        <source>Japanese Maple</source>
        <translation>Érable du Japon</translation>
    </message>
    <message>
        <source>Joshua Tree</source>
        <translation>Arbre de Josué</translation>
    </message>
    <message>
        <source>Lebanon Cedar</source>
        <translation>Cèdre du Liban</translation>
    </message>
    <message>
        <source>Live Oak</source>
        <translation>Chêne de Virginie</translation>
    </message>
    <message>
        <source>Lombardy Poplar</source>
        <translation>Peuplier d’Italie</translation>
    </message>
    <message>
        <source>London Plane</source>
        <translation>Platane commun</translation>
    </message>
    <message>
        <source>Norway Maple</source>
        <translation>Érable plane</translation>
    </message>
    <message>
        <source>Norway Spruce</source>
        <translation>Épicéa commun</translation>
    </message>
    <message>
        <source>Olive Tree</source>
        <translation>Olivier</translation>
    </message>
    <message>
        <source>Orchard Apple</source>
        <translation>Pommier domestique</translation>
    </message>
    <message>
        <source>Park Tree</source>
        <translation>Arbre de parc</translation>
    </message>
    <message>
        <source>Quaking Aspen</source>
        <translation>Peuplier faux-tremble</translation>
    </message>
    <message>
        <source>Rain Tree</source>
        <translation>Arbre à pluie</translation>
    </message>
    <message>
        <source>Red Oak</source>
        <translation>Chêne rouge d’Amérique</translation>
    </message>
    <message>
        <source>Rowan</source>
        <translation>Sorbier des oiseleurs</translation>
    </message>
    <message>
        <source>Saguaro</source>
        <translation>Cactus saguaro</translation>
    </message>
    <message>
        <source>Sapling</source>
        <translation>Jeune bouleau</translation>
    </message>
    <message>
        <source>Sassafras</source>
        <translation>Sassafras officinal</translation>
    </message>
    <message>
        <source>Scots Pine</source>
        <translation>Pin sylvestre</translation>
    </message>
    <message>
        <source>Silver Birch</source>
        <translation>Bouleau verruqueux</translation>
    </message>
    <message>
        <source>Small Leaved Linden</source>
        <translation>Tilleul à petites feuilles</translation>
    </message>
    <message>
        <source>Small Tree</source>
        <translation>Petit arbre</translation>
    </message>
    <message>
        <source>Southern Magnolia</source>
        <translation>Magnolia à grandes fleurs</translation>
    </message>
    <message>
        <source>Stone Pine</source>
        <translation>Pin parasol</translation>
    </message>
    <message>
        <source>Sugar Maple</source>
        <translation>Érable à sucre</translation>
    </message>
    <message>
        <source>Sweet Chestnut</source>
        <translation>Châtaignier commun</translation>
    </message>
    <message>
        <source>Sweetgum</source>
        <translation>Copalme d’Amérique</translation>
    </message>
    <message>
        <source>Ternary Tree</source>
        <translation>Arbre ternaire</translation>
    </message>
    <message>
        <source>Tiny Tree</source>
        <translation>Arbre minuscule</translation>
    </message>
    <message>
        <source>Tree Fern</source>
        <translation>Fougère arborescente</translation>
    </message>
    <message>
        <source>Tulip Tree</source>
        <translation>Tulipier de Virginie</translation>
    </message>
    <message>
        <source>Umbrella Acacia</source>
        <translation>Acacia parasol</translation>
    </message>
    <message>
        <source>Weeping Willow</source>
        <translation>Saule pleureur</translation>
    </message>
    <message>
        <source>White Willow</source>
        <translation>Saule blanc</translation>
    </message>
    <message>
        <source>Wild Cherry</source>
        <translation>Merisier</translation>
    </message>
    <message>
        <source>Winter Oak</source>
        <translation>Chêne en hiver</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>Latin name: habit</comment>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Grammar examples</source>
        <translation>Exemples de grammaires</translation>
    </message>
    <message>
        <source>Grows year by year: young at the age of %1, mature at %2, old at %3</source>
        <translation>Pousse année après année : jeune à l’âge de %1 ans, adulte à %2, vieux à %3</translation>
    </message>
    <message>
        <source>Coconut Palm Rules</source>
        <translation>Cocotier par règles</translation>
    </message>
    <message>
        <source>Cliff Hawthorn</source>
        <translation>Aubépine des falaises</translation>
    </message>
</context>
<context>
    <name>ramure::AboutDialog</name>
    <message>
        <source>not available</source>
        <translation>non disponible</translation>
    </message>
    <message>
        <source>About Ramure</source>
        <translation>À propos de Ramure</translation>
    </message>
    <message>
        <source>An editor for trees: from a grammar to one clean mesh.</source>
        <translation>Un éditeur d’arbres&#xa0;: d’une grammaire à un maillage propre.</translation>
    </message>
    <message>
        <source>Free software under the MIT licence.</source>
        <translation>Logiciel libre sous licence MIT.</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copier les versions</translation>
    </message>
    <message>
        <source>Ramure %1
Qt %2 (compiled with %3)
OpenGL: %4
%5</source>
        <translation>Ramure %1
Qt %2 (compilé avec %3)
OpenGL&#xa0;: %4
%5</translation>
    </message>
</context>
<context>
    <name>ramure::AnalysisStrip</name>
    <message>
        <source>Looking for triangles that run through each other…</source>
        <translation>Recherche de triangles qui se traversent…</translation>
    </message>
    <message>
        <source>Whether triangles run through each other is not known: the search was stopped.</source>
        <translation>On ne sait pas si des triangles se traversent : la recherche a été arrêtée.</translation>
    </message>
    <message>
        <source>Hash %1</source>
        <translation>Empreinte %1</translation>
    </message>
    <message>
        <source>Stop looking</source>
        <translation>Arrêter la recherche</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Avancement de la recherche</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Chercher de nouveau</translation>
    </message>
    <message>
        <source>Move apart…</source>
        <translation>Écarter…</translation>
    </message>
    <message>
        <source>Turn the thinner branch of each colliding pair as little as it takes. Lengths stay.</source>
        <translation>Tourner la plus mince des branches de chaque paire qui se heurte, aussi peu que possible. Les longueurs restent.</translation>
    </message>
    <message>
        <source>A name for the mesh: equal on every machine where all positions and triangles are equal</source>
        <translation>Un nom pour le maillage : le même sur toute machine quand toutes les positions et tous les triangles sont les mêmes</translation>
    </message>
    <message>
        <source>Triangles by their smallest angle, from 0° to 60°; the height is the square root of their number</source>
        <translation>Triangles selon leur plus petit angle, de 0° à 60° ; la hauteur est la racine carrée de leur nombre</translation>
    </message>
    <message>
        <source>Triangles by their smallest angle</source>
        <translation>Triangles selon leur plus petit angle</translation>
    </message>
</context>
<context>
    <name>ramure::ArmBaker</name>
    <message>
        <source>Bake the arm to keys</source>
        <translation>Transformer le mouvement du bras en clés</translation>
    </message>
</context>
<context>
    <name>ramure::ArmMeshRow</name>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Own mesh, %1 triangles</source>
        <translation>Son propre maillage, %1 triangles</translation>
    </message>
    <message>
        <source>Wear the cylinder</source>
        <translation>Porter le cylindre</translation>
    </message>
    <message>
        <source>The file has no triangles: the arm cannot wear it.</source>
        <translation>Le fichier n&apos;a pas de triangles : le bras ne peut pas le porter.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
    <message>
        <source>Outer shape of the arm: the cylinder, or a copy of an imported mesh whose vertices follow the nearest segments. The object itself is hidden.</source>
        <translation>Forme du bras : le cylindre, ou une copie d’un maillage importé dont les sommets suivent les segments les plus proches. L’objet lui-même est masqué.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Depuis un fichier…</translation>
    </message>
    <message>
        <source>Imports an object and binds it to the arm</source>
        <translation>Importe un objet et le lie au bras</translation>
    </message>
    <message>
        <source>Fit again</source>
        <translation>Réajuster</translation>
    </message>
    <message>
        <source>Makes the worn mesh as long as the arm is now, its foot on the arm&apos;s foot. A mesh is bound to the straight arm: lengths that change later move the joints along it and do not stretch it.</source>
        <translation>Donne au maillage porté la longueur actuelle du bras, son pied sur celui du bras. Un maillage est lié au bras tendu&#xa0;: les longueurs changées ensuite déplacent les articulations le long du maillage sans l’étirer.</translation>
    </message>
    <message>
        <source>The object that the arm&apos;s mesh was copied from is not in the scene: choose one again under “Skin”.</source>
        <translation>L’objet dont le maillage du bras est la copie n’est plus dans la scène : choisissez-en un à nouveau sous « Peau ».</translation>
    </message>
    <message>
        <source>Makes the mesh as long as the arm and stands it on the foot; otherwise it is bound where it stands around the straight arm</source>
        <translation>Donne au maillage la longueur du bras et le pose sur le pied ; sinon, il est lié là où il se tient autour du bras tendu</translation>
    </message>
    <message>
        <source>The longest along</source>
        <translation>Le plus long, le long</translation>
    </message>
    <message>
        <source>X along</source>
        <translation>X le long</translation>
    </message>
    <message>
        <source>Y along</source>
        <translation>Y le long</translation>
    </message>
    <message>
        <source>Z along</source>
        <translation>Z le long</translation>
    </message>
    <message>
        <source>Axis along the arm</source>
        <translation>Axe le long du bras</translation>
    </message>
    <message>
        <source>Which axis of a fitted mesh lies along the arm: of a tree that is Y. The mesh that is worn is put on again.</source>
        <translation>L’axe d’un maillage ajusté qui s’aligne sur le bras : Y pour un arbre. Le maillage porté est revêtu à nouveau.</translation>
    </message>
</context>
<context>
    <name>ramure::ArmPanel</name>
    <message>
        <source>Joint %1</source>
        <translation>Articulation %1</translation>
    </message>
    <message>
        <source>No arm. Edit &gt; Add to the scene &gt; Arm makes one; the demo of the arm has one already.</source>
        <translation>Pas de bras. Édition &gt; Ajouter à la scène &gt; Bras en crée un ; la démo du bras en a déjà un.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Adds a joint behind the chosen one, the same as it (1 to 64)</source>
        <translation>Ajoute une articulation derrière celle choisie, identique (1 à 64)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Takes the chosen joint out</source>
        <translation>Enlève l&apos;articulation choisie</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Atteindre</translation>
    </message>
    <message>
        <source>Sends the arm to its target; Ctrl+click on a terrain sets another one</source>
        <translation>Envoie le bras à sa cible ; Ctrl+clic sur un terrain en choisit une autre</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Holds the arm on its way, to go through it step by step</source>
        <translation>Arrête le bras en chemin, pour avancer pas à pas</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas à pas</translation>
    </message>
    <message>
        <source>One sixtieth of a second further</source>
        <translation>Un soixantième de seconde plus loin</translation>
    </message>
    <message>
        <source>Key the pose</source>
        <translation>Clés de la pose</translation>
    </message>
    <message>
        <source>The arm follows its keys now, no target.</source>
        <translation>Le bras suit maintenant ses clés, plus aucune cible.</translation>
    </message>
    <message>
        <source>Inserts a key at this frame for the angles of all joints</source>
        <translation>Insère à cette image une clé pour les angles de toutes les articulations</translation>
    </message>
    <message>
        <source>Bake to keys…</source>
        <translation>Transformer en clés…</translation>
    </message>
    <message>
        <source>The motion towards the target becomes keys of the joints&apos; angles, at the frames you choose; then the arm follows those</source>
        <translation>Le mouvement vers la cible devient des clés des angles des articulations, aux images que vous choisissez&#xa0;; le bras suit ensuite ces clés</translation>
    </message>
</context>
<context>
    <name>ramure::ArmReach</name>
    <message>
        <source>Reach for the target</source>
        <translation>Atteindre la cible</translation>
    </message>
</context>
<context>
    <name>ramure::AutoKey</name>
    <message>
        <source>Set Key</source>
        <translation>Placer une clé</translation>
    </message>
</context>
<context>
    <name>ramure::BakeActions</name>
    <message>
        <source>Baked motion is not used: frames are computed when they are needed.</source>
        <translation>Le mouvement précalculé n’est pas utilisé : les images sont calculées au besoin.</translation>
    </message>
    <message>
        <source>The motion cannot be baked.</source>
        <translation>Le mouvement ne peut pas être précalculé.</translation>
    </message>
    <message>
        <source>Not all of the baked motion could be deleted.</source>
        <translation>Le mouvement précalculé n’a pas pu être supprimé en entier.</translation>
    </message>
    <message>
        <source>The baked motion is deleted</source>
        <translation>Le mouvement précalculé est supprimé</translation>
    </message>
    <message>
        <source>Baking was cancelled; no half-written file stays</source>
        <translation>Précalcul annulé ; aucun fichier inachevé ne reste</translation>
    </message>
    <message>
        <source>The motion could not be baked.</source>
        <translation>Le mouvement n’a pas pu être précalculé.</translation>
    </message>
    <message>
        <source>The motion is baked: %1 beside the project</source>
        <translation>Mouvement précalculé : %1 à côté du projet</translation>
    </message>
    <message>
        <source>Baked: every frame of the range comes at once</source>
        <translation>Précalculé : chaque image de la plage vient aussitôt</translation>
    </message>
    <message>
        <source>The baked motion is of another tree or of other parameters and is not used</source>
        <translation>Le mouvement précalculé vient d’un autre arbre ou d’autres paramètres et n’est pas utilisé</translation>
    </message>
    <message>
        <source>Bake the motion</source>
        <translation>Précalculer le mouvement</translation>
    </message>
    <message>
        <source>Save the project first?</source>
        <translation>Enregistrer d’abord le projet&#xa0;?</translation>
    </message>
    <message>
        <source>Baked motion is kept in files beside the project file, so that it is there when the project is opened again. This project has no file yet.</source>
        <translation>Le mouvement précalculé est gardé dans des fichiers à côté de celui du projet, pour être là à la prochaine ouverture. Ce projet n’a pas encore de fichier.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
</context>
<context>
    <name>ramure::BakeKeysDialog</name>
    <message>
        <source>Bake &quot;%1&quot; to keys</source>
        <translation>Transformer «&#xa0;%1&#xa0;» en clés</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Images</translation>
    </message>
    <message>
        <source>&amp;A key every</source>
        <translation>Une &amp;clé toutes les</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>&amp;Tolérance</translation>
    </message>
    <message>
        <source>First frame that gets a key</source>
        <translation>Première image qui reçoit une clé</translation>
    </message>
    <message>
        <source>Last frame that gets a key, whatever the step</source>
        <translation>Dernière image qui reçoit une clé, quel que soit le pas</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>Whole timeline</source>
        <translation>Toute la durée</translation>
    </message>
    <message>
        <source>Frames %1 to %2</source>
        <translation>Images %1 à %2</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> images</translation>
    </message>
    <message>
        <source>Frames from one key to the next: 1 gives each a key; between keys the angles go straight</source>
        <translation>Images d’une clé à la suivante&#xa0;: 1 donne une clé à chacune&#xa0;; entre les clés, les angles vont tout droit</translation>
    </message>
    <message>
        <source>Frames from one key to the next</source>
        <translation>Images d’une clé à la suivante</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Keys that a straight line comes as near to are left out, degrees; 0 keeps all</source>
        <translation>Les clés qu’une droite approche d’aussi près sont omises, en degrés&#xa0;; 0 les garde toutes</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>The target &amp;gets a key too</source>
        <translation>La ci&amp;ble reçoit aussi une clé</translation>
    </message>
    <message>
        <source>If the target has no keys yet. It then stays in place, as during the baking</source>
        <translation>Si la cible n’a pas encore de clés. Elle reste alors en place, comme pendant la transformation</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>T&amp;ransformer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>The last frame stands before the first one.</source>
        <translation>La dernière image précède la première.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n key(s) for each angle. Then the arm follows its keys, no target.</source>
        <translation>
            <numerusform>Au plus %n clé par angle. Le bras suit ensuite ses clés, et non une cible.</numerusform>
            <numerusform>Au plus %n clés par angle. Le bras suit ensuite ses clés, et non une cible.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) for each angle. Then the arm follows its keys, no target.</source>
        <translation>
            <numerusform>%n clé par angle. Le bras suit ensuite ses clés, et non une cible.</numerusform>
            <numerusform>%n clés par angle. Le bras suit ensuite ses clés, et non une cible.</numerusform>
        </translation>
    </message>
    <message>
        <source> frame</source>
        <translation> image</translation>
    </message>
</context>
<context>
    <name>ramure::BendTool</name>
    <message>
        <source>The limb bows · wheel: over how much of it · release: done · Esc: back</source>
        <translation>La branche plie · molette : sur quelle longueur · relâcher : terminé · Échap : retour</translation>
    </message>
    <message>
        <source>Drag: the limb bows along its green part, the bright part follows · Shift: down to the ground</source>
        <translation>Glisser : la branche plie dans sa partie verte, la partie claire suit · Maj : jusqu’au sol</translation>
    </message>
    <message>
        <source>Drag a branch: the limb bows as the hand goes</source>
        <translation>Glisser une branche : elle plie en suivant la main</translation>
    </message>
    <message>
        <source>influence %1 m</source>
        <translation>influence %1 m</translation>
    </message>
    <message>
        <source>Bend %1°</source>
        <translation>Flexion %1°</translation>
    </message>
</context>
<context>
    <name>ramure::BillboardActions</name>
    <message>
        <source>Billboard: there is no OpenGL here to draw it</source>
        <translation>Billboard : il n’y a pas ici d’OpenGL pour le dessiner</translation>
    </message>
    <message>
        <source>Billboard: one is being drawn; the next can follow it</source>
        <translation>Billboard : un dessin est en cours ; le suivant pourra venir après</translation>
    </message>
    <message>
        <source>Billboard: nothing is visible in the scene</source>
        <translation>Billboard : rien n’est visible dans la scène</translation>
    </message>
    <message>
        <source>Billboard</source>
        <translation>Billboard</translation>
    </message>
    <message>
        <source>tree_cards</source>
        <translation>arbre_cartes</translation>
    </message>
    <message>
        <source>glTF binary (*.glb)</source>
        <translation>glTF binaire (*.glb)</translation>
    </message>
    <message>
        <source>%1: cards are written as a GLB file; the name has to end in .glb</source>
        <translation>%1 : les cartes s’écrivent dans un fichier GLB ; le nom doit finir par .glb</translation>
    </message>
    <message>
        <source>Folder for the billboard</source>
        <translation>Dossier du billboard</translation>
    </message>
    <message>
        <source>Replace the files of an earlier billboard?</source>
        <translation>Remplacer les fichiers d’un billboard précédent ?</translation>
    </message>
    <message>
        <source>In %1: %2</source>
        <translation>Dans %1 : %2</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>No billboard was written</source>
        <translation>Aucun billboard n’a été écrit</translation>
    </message>
</context>
<context>
    <name>ramure::BillboardDialog</name>
    <message>
        <source>%1 triangles with one picture of their colours and one of their normals.</source>
        <translation>%1 triangles, avec une image de leurs couleurs et une de leurs normales.</translation>
    </message>
    <message>
        <source>%1 views of %2 px each: two PNG pictures and atlas.json, in a folder.</source>
        <translation>%1 vues de %2 px chacune : deux images PNG et atlas.json, dans un dossier.</translation>
    </message>
    <message>
        <source>%1 px are not a multiple of %2 views.</source>
        <translation>%1 px ne sont pas un multiple de %2 vues.</translation>
    </message>
    <message>
        <source>A view would have %1 px a side; at least %2 px are needed.</source>
        <translation>Une vue aurait %1 px de côté ; il en faut au moins %2.</translation>
    </message>
    <message>
        <source>Numbers of views that fit: %1.</source>
        <translation>Nombres de vues possibles : %1.</translation>
    </message>
    <message>
        <source>Billboard</source>
        <translation>Billboard</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Sorte</translation>
    </message>
    <message>
        <source>What stands for trees that are far away.
Cards: upright rectangles through the middle, for any program. Atlas: pictures from all around and above, for impostors of game engines</source>
        <translation>Ce qui tient lieu d’arbres lointains.
Cartes : des rectangles debout par le milieu, pour tout logiciel. Atlas : des vues prises de partout et d’en haut, pour les imposteurs des moteurs de jeu</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Cartes</translation>
    </message>
    <message>
        <source>How many stand, 1 to 16, evenly turned; two triangles each</source>
        <translation>Combien sont debout, de 1 à 16, tournées régulièrement ; deux triangles chacune</translation>
    </message>
    <message>
        <source>A card that is seen from above</source>
        <translation>Une carte vue d’en haut</translation>
    </message>
    <message>
        <source>Views each way</source>
        <translation>Vues par côté</translation>
    </message>
    <message>
        <source>Views in a row and in a column, 2 to 32. The size has to be a multiple of this number, with at least 16 px for each view</source>
        <translation>Vues par ligne et par colonne, de 2 à 32. La taille doit être un multiple de ce nombre, avec au moins 16 px par vue</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Width and height of the pictures in pixels</source>
        <translation>Largeur et hauteur des images en pixels</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>A folder gets cards.glb, cards_colour.png and cards_normal.png</source>
        <translation>Un dossier reçoit cards.glb, cards_colour.png et cards_normal.png</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Arbres</translation>
    </message>
    <message>
        <source>Draws the selected nodes and their children. If off, draws everything visible, as it is at the time shown</source>
        <translation>Dessine les nœuds sélectionnés et leurs enfants. Sinon, dessine tout ce qui est visible, tel qu’à l’instant montré</translation>
    </message>
    <message>
        <source>Crossed cards</source>
        <translation>Cartes croisées</translation>
    </message>
    <message>
        <source>Atlas of views</source>
        <translation>Atlas de vues</translation>
    </message>
    <message>
        <source>One more lies</source>
        <translation>Une de plus, couchée</translation>
    </message>
    <message>
        <source>One GLB file</source>
        <translation>Un fichier GLB</translation>
    </message>
    <message>
        <source>A folder: GLB and PNG pictures</source>
        <translation>Un dossier : GLB et images PNG</translation>
    </message>
    <message>
        <source>Selection only</source>
        <translation>Seulement la sélection</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ramure::BookmarkActions</name>
    <message>
        <source>There is no bookmark %1 yet: %2 keeps the present view there.</source>
        <translation>Il n&apos;y a pas encore de signet %1 : %2 y garde la vue actuelle.</translation>
    </message>
    <message>
        <source>The view is kept as bookmark %1: %2 comes back to it.</source>
        <translation>La vue est gardée comme signet %1 : %2 y revient.</translation>
    </message>
    <message>
        <source>front</source>
        <translation>de face</translation>
    </message>
    <message>
        <source>front right</source>
        <translation>de face à droite</translation>
    </message>
    <message>
        <source>right</source>
        <translation>de droite</translation>
    </message>
    <message>
        <source>back right</source>
        <translation>de dos à droite</translation>
    </message>
    <message>
        <source>back</source>
        <translation>de dos</translation>
    </message>
    <message>
        <source>back left</source>
        <translation>de dos à gauche</translation>
    </message>
    <message>
        <source>left</source>
        <translation>de gauche</translation>
    </message>
    <message>
        <source>front left</source>
        <translation>de face à gauche</translation>
    </message>
    <message>
        <source>above</source>
        <translation>d&apos;en haut</translation>
    </message>
    <message>
        <source>below</source>
        <translation>d&apos;en bas</translation>
    </message>
    <message>
        <source>%1, %2 m</source>
        <translation>%1, %2 m</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
    <message>
        <source>Go back to this view</source>
        <translation>Revenir à cette vue</translation>
    </message>
    <message>
        <source>Keep the present view in the project</source>
        <translation>Garder la vue actuelle dans le projet</translation>
    </message>
    <message>
        <source>Forget bookmark &amp;%1</source>
        <translation>Oublier le signet &amp;%1</translation>
    </message>
    <message>
        <source>&amp;Bookmarks</source>
        <translation>Si&amp;gnets</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Oublier</translation>
    </message>
    <message>
        <source>Go to bookmark &amp;%1: %2</source>
        <translation>Aller au signet &amp;%1 : %2</translation>
    </message>
    <message>
        <source>Nothing is kept here yet, see “Keep the view”</source>
        <translation>Rien n&apos;est encore gardé ici, voir « Garder la vue »</translation>
    </message>
    <message>
        <source>Keep the view as bookmark &amp;%1, instead of %2</source>
        <translation>Garder la vue comme signet &amp;%1, au lieu de %2</translation>
    </message>
    <message>
        <source>Keep the view as bookmark &amp;%1</source>
        <translation>Garder la vue comme signet &amp;%1</translation>
    </message>
    <message>
        <source>&amp;Keep the view</source>
        <translation>&amp;Garder la vue</translation>
    </message>
</context>
<context>
    <name>ramure::BoolEditor</name>
    <message>
        <source>on</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>off</source>
        <translation>non</translation>
    </message>
</context>
<context>
    <name>ramure::BranchFactForm</name>
    <message>
        <source>none: a root</source>
        <translation>aucun&#xa0;: une racine</translation>
    </message>
    <message>
        <source>none: a tip</source>
        <translation>aucun&#xa0;: un bout</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n de plus</numerusform>
            <numerusform>et %n de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>The branch at whose end this one starts. Click to select it.</source>
        <translation>La branche au bout de laquelle celle-ci commence. Cliquez pour la sélectionner.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Enfants</translation>
    </message>
    <message>
        <source>The branches that start at this one&apos;s end. Click to select one.</source>
        <translation>Les branches qui partent du bout de celle-ci. Cliquez pour en sélectionner une.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>How many brackets of the grammar are around the branch: 0 is the trunk.</source>
        <translation>Combien de crochets de la grammaire entourent la branche&#xa0;: 0 est le tronc.</translation>
    </message>
    <message>
        <source>Start (p0)</source>
        <translation>Début (p0)</translation>
    </message>
    <message>
        <source>In the tree&apos;s space, Y up.</source>
        <translation>Dans l’espace de l’arbre, Y vers le haut.</translation>
    </message>
    <message>
        <source>End (p1)</source>
        <translation>Fin (p1)</translation>
    </message>
    <message>
        <source>Start radius (a0)</source>
        <translation>Rayon au début (a0)</translation>
    </message>
    <message>
        <source>End radius (a1)</source>
        <translation>Rayon à la fin (a1)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>From the start straight to the end.</source>
        <translation>Du début à la fin, en ligne droite.</translation>
    </message>
    <message>
        <source>Angle to the parent</source>
        <translation>Angle au parent</translation>
    </message>
    <message>
        <source>Between the branch&apos;s direction and its parent&apos;s; of a root, between it and up (+Y).</source>
        <translation>Entre la direction de la branche et celle de son parent&#xa0;; pour une racine, entre elle et le haut (+Y).</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Which way the branch leans around its parent: from the normal of the parent&apos;s last section towards its binormal. A root is measured from +X towards −Z.</source>
        <translation>De quel côté du parent la branche penche&#xa0;: de la normale de la dernière section du parent vers sa binormale. Une racine se mesure de +X vers −Z.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>For the movement in the wind, without unit: the radius at the end, 0.075 for an apple, and the masses of all it carries.</source>
        <translation>Pour le mouvement dans le vent, sans unité&#xa0;: le rayon à la fin, 0,075 pour une pomme, et les masses de tout ce qu’elle porte.</translation>
    </message>
</context>
<context>
    <name>ramure::BranchInspector</name>
    <message>
        <source>This tree has no branches: %1</source>
        <translation>Cet arbre n’a pas de branches&#xa0;: %1</translation>
    </message>
    <message>
        <source>Select a branch in the viewport or in the scene panel.</source>
        <translation>Sélectionnez une branche dans la vue ou dans le panneau Scène.</translation>
    </message>
    <message numerus="yes">
        <source>%1 · the active one of %n selected branch(es)</source>
        <translation>
            <numerusform>%1 · l’active, %n branche sélectionnée</numerusform>
            <numerusform>%1 · l’active parmi %n branches sélectionnées</numerusform>
        </translation>
    </message>
    <message>
        <source>Branch inspector</source>
        <translation>Inspecteur de branche</translation>
    </message>
    <message>
        <source>Section %1</source>
        <translation>Section %1</translation>
    </message>
    <message>
        <source>%1 · branch %2 in reports</source>
        <translation>%1 · branche %2 dans les rapports</translation>
    </message>
    <message>
        <source>%1 · the whole limb is selected; the figures are those of: %2</source>
        <translation>%1 · toute la branche est sélectionnée ; les chiffres sont ceux de : %2</translation>
    </message>
</context>
<context>
    <name>ramure::BrushTool</name>
    <message>
        <source>Press on the tree that is meant, or select it first.</source>
        <translation>Appuyez sur l’arbre voulu, ou sélectionnez-le d’abord.</translation>
    </message>
    <message>
        <source>Drag over branches: they turn the way of the stroke.</source>
        <translation>Glissez sur des branches : elles tournent dans le sens du trait.</translation>
    </message>
    <message>
        <source>Release: done · wheel: radius · Esc: back</source>
        <translation>Lâcher : fait · molette : rayon · Échap : retour</translation>
    </message>
    <message>
        <source>Release: done · wheel: radius · digits: strength in % · Esc: back</source>
        <translation>Lâcher : fait · molette : rayon · chiffres : force en % · Échap : retour</translation>
    </message>
    <message>
        <source>Shift + wheel: radius</source>
        <translation>Maj + molette : rayon</translation>
    </message>
    <message>
        <source>Press or drag: branches turn towards the hand</source>
        <translation>Appuyer ou glisser : les branches se tournent vers la main</translation>
    </message>
    <message>
        <source>Press or drag: branches turn away from the hand</source>
        <translation>Appuyer ou glisser : les branches se détournent de la main</translation>
    </message>
    <message>
        <source>Drag over branches: they turn the way of the stroke</source>
        <translation>Glisser sur des branches : elles tournent dans le sens du trait</translation>
    </message>
    <message>
        <source>Drag over twigs: their leaves go</source>
        <translation>Glisser sur des rameaux : leurs feuilles s’en vont</translation>
    </message>
    <message>
        <source>Drag over twigs: their leaves come back</source>
        <translation>Glisser sur des rameaux : leurs feuilles reviennent</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>rayon %1 m</translation>
    </message>
    <message>
        <source>%1 % · radius %2 m</source>
        <translation>%1 % · rayon %2 m</translation>
    </message>
</context>
<context>
    <name>ramure::Callout</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Ends the tour (Esc); the Help menu starts it again</source>
        <translation>Termine la visite (Échap) ; le menu Aide la relance</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
</context>
<context>
    <name>ramure::CameraActions</name>
    <message>
        <source>There is no camera: Edit &gt; Add to the scene &gt; Camera makes one from this view.</source>
        <translation>Il n’y a pas de caméra : Édition &gt; Ajouter à la scène &gt; Caméra en fait une de cette vue.</translation>
    </message>
    <message>
        <source>This camera is locked or hidden.</source>
        <translation>Cette caméra est verrouillée ou masquée.</translation>
    </message>
    <message>
        <source>Move the camera here</source>
        <translation>Amener la caméra ici</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Caméra</translation>
    </message>
</context>
<context>
    <name>ramure::ColorEditor</name>
    <message>
        <source>“%1” is no colour: write six digits like #8b5a2b</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une couleur&#xa0;: écrire six chiffres comme #8b5a2b</translation>
    </message>
    <message>
        <source>%1: choose</source>
        <translation>%1&#xa0;: choisir</translation>
    </message>
    <message>
        <source>Choose a colour</source>
        <translation>Choisir une couleur</translation>
    </message>
</context>
<context>
    <name>ramure::CubeTool</name>
    <message>
        <source>The view turns · release: done</source>
        <translation>La vue tourne · relâcher : terminer</translation>
    </message>
    <message>
        <source>Click: look from this side · drag: turn the view</source>
        <translation>Clic : regarder de ce côté · glisser : tourner la vue</translation>
    </message>
</context>
<context>
    <name>ramure::CutTool</name>
    <message>
        <source>Click a branch: cut it there</source>
        <translation>Clic sur une branche : la couper là</translation>
    </message>
    <message>
        <source>Click: cut here, %1 would go</source>
        <translation>Clic : couper ici, %1 partiraient</translation>
    </message>
    <message>
        <source>Release: cut here, %1 would go · Esc: not at all</source>
        <translation>Relâcher : couper ici, %1 partiraient · Échap : rien</translation>
    </message>
    <message>
        <source>Release: nothing is cut</source>
        <translation>Relâcher : rien n’est coupé</translation>
    </message>
</context>
<context>
    <name>ramure::DrawTool</name>
    <message>
        <source>A branch grows along the line · release: done · Esc: none</source>
        <translation>Une branche pousse le long du trait · lâcher : fait · Échap : aucune</translation>
    </message>
    <message>
        <source>Drag from a branch or the ground: a new branch along the line</source>
        <translation>Glisser à partir d’une branche ou du sol : une nouvelle branche le long du trait</translation>
    </message>
    <message>
        <source>A new branch begins on a branch, or on the ground near the tree: press there, and drag.</source>
        <translation>Une nouvelle branche commence sur une branche, ou au sol près de l’arbre : appuyez là, et glissez.</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Press on the branch that is meant, and drag.</source>
        <translation>Appuyez sur la branche voulue, et glissez.</translation>
    </message>
    <message>
        <source>The tip grows on along the line · release: done · Esc: as it was</source>
        <translation>Le bout pousse le long du trait · lâcher : fait · Échap : comme avant</translation>
    </message>
    <message>
        <source>The branch goes along the line · release: done · Esc: as it was</source>
        <translation>La branche suit le trait · lâcher : fait · Échap : comme avant</translation>
    </message>
    <message>
        <source>Drag a branch: its tip grows on as the hand goes</source>
        <translation>Glisser une branche : son bout pousse comme va la main</translation>
    </message>
    <message>
        <source>Drag from a branch: from there on it goes along the line</source>
        <translation>Glisser à partir d’une branche : de là, elle suit le trait</translation>
    </message>
    <message>
        <source>Nothing grows from here: release, and press on a branch or the ground</source>
        <translation>Rien ne pousse d’ici : relâchez, et appuyez sur une branche ou sur le sol</translation>
    </message>
    <message>
        <source>Nothing happens here: release, and press on the branch that is meant</source>
        <translation>Il ne se passe rien ici : relâchez, et appuyez sur la branche voulue</translation>
    </message>
    <message>
        <source>radius %1 cm</source>
        <translation>rayon %1 cm</translation>
    </message>
</context>
<context>
    <name>ramure::EditActions</name>
    <message>
        <source>&amp;Add to the scene</source>
        <translation>A&amp;jouter à la scène</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Duplicate %1</source>
        <translation>&amp;Dupliquer %1</translation>
    </message>
    <message>
        <source>Rena&amp;me %1</source>
        <translation>Re&amp;nommer %1</translation>
    </message>
    <message>
        <source>S&amp;how %1</source>
        <translation>A&amp;fficher %1</translation>
    </message>
    <message>
        <source>&amp;Hide %1</source>
        <translation>&amp;Masquer %1</translation>
    </message>
    <message>
        <source>Unloc&amp;k %1</source>
        <translation>Dé&amp;verrouiller %1</translation>
    </message>
    <message>
        <source>Loc&amp;k %1</source>
        <translation>&amp;Verrouiller %1</translation>
    </message>
    <message>
        <source>De&amp;lete %1</source>
        <translation>&amp;Supprimer %1</translation>
    </message>
    <message>
        <source>New tree: nothing can vary. No rule has chances, and the variation of angles, lengths and radii is 0 %</source>
        <translation>Nouvel arbre : rien ne peut varier. Aucune règle ne comporte de hasard, et la variation des angles, longueurs et rayons est de 0 %</translation>
    </message>
    <message>
        <source>Make it %1</source>
        <comment>undo step; the name of a preset</comment>
        <translation>En faire %1</translation>
    </message>
    <message numerus="yes">
        <source>De&amp;lete %Ln branch(es)</source>
        <translation>
            <numerusform>Su&amp;pprimer %Ln branche</numerusform>
            <numerusform>Su&amp;pprimer %Ln branches</numerusform>
        </translation>
    </message>
    <message>
        <source>Make it a &amp;tree of its own</source>
        <translation>En faire un &amp;arbre à part entière</translation>
    </message>
    <message>
        <source>This copy becomes a node beside the scatter, at the same place</source>
        <translation>Cette copie devient un nœud à côté du semis, à la même place</translation>
    </message>
    <message>
        <source>Take this &amp;copy away</source>
        <translation>Retirer cette &amp;copie</translation>
    </message>
    <message>
        <source>The scatter leaves this copy out; its place stays empty</source>
        <translation>Le semis omet cette copie ; sa place reste vide</translation>
    </message>
</context>
<context>
    <name>ramure::EditTool</name>
    <message numerus="yes">
        <source>At %n place(s) around the trunk no limb is like it: nothing happens there.</source>
        <translation>
            <numerusform>À %n endroit autour du tronc, aucune branche ne lui ressemble : il ne s’y passe rien.</numerusform>
            <numerusform>À %n endroits autour du tronc, aucune branche ne leur ressemble : il ne s’y passe rien.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut: the part falls when the timeline plays.</source>
        <translation>Coupé : la partie tombe quand l’animation est lue.</translation>
    </message>
    <message numerus="yes">
        <source>%n branch(es), %1 m</source>
        <translation>
            <numerusform>%n branche, %1 m</numerusform>
            <numerusform>%n branches, %1 m</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift + wheel: the limb that it grows on</source>
        <translation>Maj + molette : la branche qui la porte</translation>
    </message>
    <message>
        <source>Shift: wheel takes the limb that it grows on, or back</source>
        <translation>Maj : la molette prend la branche qui la porte, ou revient</translation>
    </message>
    <message>
        <source>No limb is there: click on one, or a few pixels beside it.</source>
        <translation>Il n’y a pas de branche là&#xa0;: cliquez sur une branche, ou à quelques pixels d’elle.</translation>
    </message>
</context>
<context>
    <name>ramure::EmptyPage</name>
    <message>
        <source>The scene is empty. Choose a tree in the gallery, use the menu Edit &gt; Add to the scene, or drop a file onto the window.</source>
        <translation>La scène est vide. Choisissez un arbre dans la galerie, passez par le menu Édition &gt; Ajouter à la scène, ou déposez un fichier sur la fenêtre.</translation>
    </message>
</context>
<context>
    <name>ramure::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Waiting until the tree is computed…</source>
        <translation>En attente du calcul de l’arbre…</translation>
    </message>
    <message>
        <source>Cancelled. No file was changed.</source>
        <translation>Annulé. Aucun fichier n’a été modifié.</translation>
    </message>
    <message>
        <source>Selection only</source>
        <translation>Seulement la sélection</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progression de l’export</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Exporter quand même</translation>
    </message>
    <message>
        <source>Export it all the same?</source>
        <translation>L’exporter quand même ?</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>PNG pictures of the view</source>
        <translation>Images PNG de la vue</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Instant</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message numerus="yes">
        <source>%Ln file(s)</source>
        <translation>
            <numerusform>%Ln fichier</numerusform>
            <numerusform>%Ln fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>Another sequence is still being written: its progress stands in the status bar.</source>
        <translation>Une autre suite est encore en cours d’écriture : sa progression est dans la barre d’état.</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>Il n’y a pas de dossier «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Trees, arms as they are at the moment, terrains, primitives and imported meshes are written where they stand in the world, each under a name of its own.</source>
        <translation>Les arbres, les bras tels qu&apos;ils sont à cet instant, les terrains, les primitives et les maillages importés sont écrits là où ils se trouvent dans le monde, chacun sous son propre nom.</translation>
    </message>
    <message>
        <source>Hidden nodes too</source>
        <translation>Aussi les nœuds masqués</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Axes and unit</source>
        <translation>Axes et unité</translation>
    </message>
    <message>
        <source>PNG pictures</source>
        <translation>Images PNG</translation>
    </message>
    <message numerus="yes">
        <source>%Ln frame(s) in one file</source>
        <translation>
            <numerusform>%Ln image dans un seul fichier</numerusform>
            <numerusform>%Ln images dans un seul fichier</numerusform>
        </translation>
    </message>
    <message>
        <source>For print</source>
        <translation>Impression 3D</translation>
    </message>
    <message>
        <source>Pictures need a view, which this machine cannot draw</source>
        <translation>Les images demandent une vue, que cette machine ne peut pas dessiner</translation>
    </message>
    <message>
        <source>Purpose of the export</source>
        <translation>Usage de l’export</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>In the view behind this dialog, trees move as they will in that engine</source>
        <translation>Dans la vue derrière ce dialogue, les arbres bougent comme ils le feront dans ce moteur</translation>
    </message>
    <message>
        <source>MP4 film of the view (H.264)</source>
        <translation>Film MP4 de la vue (H.264)</translation>
    </message>
    <message>
        <source>WebM film of the view (VP9)</source>
        <translation>Film WebM de la vue (VP9)</translation>
    </message>
    <message>
        <source>Unknown file ending: .%1 is expected</source>
        <translation>Extension de fichier inconnue : .%1 est attendue</translation>
    </message>
    <message>
        <source>A film needs a sequence of frames, or a view from all sides.</source>
        <translation>Un film demande une suite d’images, ou une vue de tous les côtés.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln of these files are there already. “Replace” writes over them.</source>
        <translation>
            <numerusform>%Ln de ces fichiers existe déjà. «&#xa0;Remplacer&#xa0;» écrit par-dessus.</numerusform>
            <numerusform>%Ln de ces fichiers existent déjà. «&#xa0;Remplacer&#xa0;» écrit par-dessus.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is there already. “Replace” writes over it.</source>
        <translation>«&#xa0;%1&#xa0;» existe déjà. «&#xa0;Remplacer&#xa0;» écrit par-dessus.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
</context>
<context>
    <name>ramure::FactorTool</name>
    <message>
        <source>Digits: factor · wheel: more or less · Enter or click: done · Esc: back</source>
        <translation>Chiffres : facteur · molette : plus ou moins · Entrée ou clic : fait · Échap : retour</translation>
    </message>
    <message>
        <source>Release: done · wheel: more or less · digits: factor · Ctrl: steps · Esc: back</source>
        <translation>Lâcher : fait · molette : plus ou moins · chiffres : facteur · Ctrl : par pas · Échap : retour</translation>
    </message>
    <message>
        <source>Drag a branch along itself: its length</source>
        <translation>Glisser une branche le long d’elle-même : sa longueur</translation>
    </message>
    <message>
        <source>Drag a branch to the right or left: its thickness</source>
        <translation>Glisser une branche à droite ou à gauche : son épaisseur</translation>
    </message>
    <message>
        <source>Click: type a factor</source>
        <translation>Clic : taper un facteur</translation>
    </message>
    <message>
        <source>Length × %1</source>
        <translation>Longueur × %1</translation>
    </message>
    <message>
        <source>Thickness × %1</source>
        <translation>Épaisseur × %1</translation>
    </message>
    <message>
        <source> · type a number</source>
        <translation> · tapez un nombre</translation>
    </message>
    <message>
        <source>Thickness of the tip × %1</source>
        <translation>Épaisseur du bout × %1</translation>
    </message>
    <message>
        <source>Drag a branch to the right or left: how thick its tip is</source>
        <translation>Glisser une branche à droite ou à gauche : l’épaisseur de son bout</translation>
    </message>
    <message>
        <source>Curl %1°</source>
        <translation>Enroulement %1°</translation>
    </message>
    <message>
        <source>Drag a branch to one side: it rolls up that way</source>
        <translation>Glisser une branche vers un côté : elle s’enroule par là</translation>
    </message>
    <message>
        <source>Twist %1°</source>
        <translation>Torsion %1°</translation>
    </message>
    <message>
        <source>Drag a branch to the right or left: its twigs turn</source>
        <translation>Glisser une branche à droite ou à gauche : ses rameaux tournent</translation>
    </message>
    <message>
        <source>Digits: degrees · wheel: more or less · Enter or click: done · Esc: back</source>
        <translation>Chiffres : degrés · molette : plus ou moins · Entrée ou clic : fait · Échap : retour</translation>
    </message>
    <message>
        <source>Release: done · wheel: more or less · digits: degrees · Ctrl: steps · Esc: back</source>
        <translation>Lâcher : fait · molette : plus ou moins · chiffres : degrés · Ctrl : par pas · Échap : retour</translation>
    </message>
    <message>
        <source>Click: type an angle</source>
        <translation>Clic : taper un angle</translation>
    </message>
</context>
<context>
    <name>ramure::FaultsLine</name>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
</context>
<context>
    <name>ramure::FileActions</name>
    <message>
        <source>&amp;New from preset</source>
        <translation>&amp;Nouveau d’après un modèle</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aucun fichier</translation>
    </message>
    <message>
        <source>Forget these files</source>
        <translation>Oublier ces fichiers</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>There is no such preset.</source>
        <translation>Ce modèle n’existe pas.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>“%1” cannot be opened.</source>
        <translation>«&#xa0;%1&#xa0;» ne peut être ouvert.</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>“%1” could not be saved. Nothing is lost: the file on disk is as it was, and your changes are still open here.</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas pu être enregistré. Rien n’est perdu&#xa0;: le fichier sur le disque est intact et vos modifications sont toujours ouvertes ici.</translation>
    </message>
    <message>
        <source>New from &amp;demo</source>
        <translation>Nouveau depuis une &amp;démonstration</translation>
    </message>
    <message>
        <source>There is no such demo.</source>
        <translation>Cette démonstration n&apos;existe pas.</translation>
    </message>
    <message>
        <source>Ramure files (*.ramure)</source>
        <translation>Fichiers Ramure (*.ramure)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>All that can be opened (%1)</source>
        <translation>Tout ce qui peut être ouvert (%1)</translation>
    </message>
    <message>
        <source>Pictures that cannot be shown; their paths are kept:</source>
        <translation>Images qui ne peuvent être montrées ; leurs chemins sont gardés :</translation>
    </message>
    <message>
        <source>The pictures could not be packed.</source>
        <translation>Les images n’ont pas pu être emballées.</translation>
    </message>
    <message>
        <source>All pictures of the scene lie beside the project already.</source>
        <translation>Toutes les images de la scène sont déjà à côté du projet.</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) copied into “%1”.</source>
        <translation>
            <numerusform>%n image copiée dans « %1 ».</numerusform>
            <numerusform>%n images copiées dans « %1 ».</numerusform>
        </translation>
    </message>
    <message>
        <source>Export “%1” a&amp;gain</source>
        <translation>Exporter « %1 » à &amp;nouveau</translation>
    </message>
    <message>
        <source>Nothing was exported yet since this scene was opened: there is nothing to repeat</source>
        <translation>Rien n’a encore été exporté depuis l’ouverture de cette scène : il n’y a rien à répéter</translation>
    </message>
    <message>
        <source>Write %1 once more, with the same choices</source>
        <translation>Réécrire %1 avec les mêmes choix</translation>
    </message>
</context>
<context>
    <name>ramure::GalleryPanel</name>
    <message>
        <source>Make it %1</source>
        <comment>undo step; the name of a preset</comment>
        <translation>En faire %1</translation>
    </message>
    <message>
        <source>&amp;Add to the scene</source>
        <translation>&amp;Ajouter à la scène</translation>
    </message>
    <message>
        <source>&amp;Give its numbers to the selected trees</source>
        <translation>&amp;Donner ses nombres aux arbres sélectionnés</translation>
    </message>
    <message>
        <source>&amp;More like this…</source>
        <translation>D’autres &amp;semblables…</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Enregistrer comme modèle</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Renommer le modèle</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom :</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renommer…</translation>
    </message>
    <message>
        <source>Move to the &amp;trash</source>
        <translation>Mettre à la &amp;corbeille</translation>
    </message>
    <message>
        <source>Show in the &amp;folder</source>
        <translation>Montrer dans le &amp;dossier</translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>&amp;Enregistrer comme modèle…</translation>
    </message>
    <message>
        <source>Keep the numbers of the selected tree among your own presets</source>
        <translation>Garder les valeurs de l’arbre sélectionné parmi vos propres modèles</translation>
    </message>
    <message>
        <source>Click: add to the scene</source>
        <translation>Clic : ajouter à la scène</translation>
    </message>
    <message>
        <source>&amp;New scene with it</source>
        <translation>&amp;Nouvelle scène avec lui</translation>
    </message>
</context>
<context>
    <name>ramure::GenerationsView</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln symbol(s)</source>
        <translation>
            <numerusform>%Ln symbole</numerusform>
            <numerusform>%Ln symboles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branche</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message>
        <source>The rules give no string yet.</source>
        <translation>Les règles ne donnent pas encore de chaîne.</translation>
    </message>
    <message>
        <source>Axiom</source>
        <translation>Axiome</translation>
    </message>
    <message>
        <source>Generation %1</source>
        <translation>Génération %1</translation>
    </message>
    <message numerus="yes">
        <source>more than %Ln symbol(s)</source>
        <translation>
            <numerusform>plus de %Ln symbole</numerusform>
            <numerusform>plus de %Ln symboles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>… and %Ln more generation(s)</source>
        <translation>
            <numerusform>… et %Ln autre génération</numerusform>
            <numerusform>… et %Ln autres générations</numerusform>
        </translation>
    </message>
    <message>
        <source>Generations</source>
        <translation>Générations</translation>
    </message>
    <message>
        <source>Hide the strings</source>
        <translation>Masquer les chaînes</translation>
    </message>
    <message>
        <source>Show the string of each generation</source>
        <translation>Afficher la chaîne de chaque génération</translation>
    </message>
    <message>
        <source>Strings of the generations</source>
        <translation>Chaînes des générations</translation>
    </message>
</context>
<context>
    <name>ramure::GizmoTool</name>
    <message>
        <source>Rotate %1</source>
        <translation>Tourner %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Redimensionner %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Drag with Ctrl to bend branches. To move the tree, select it</source>
        <translation>Glissez avec Ctrl pour plier des branches. Pour déplacer l’arbre, sélectionnez-le</translation>
    </message>
    <message>
        <source>Select a node that is shown and not locked: then it can be moved</source>
        <translation>Sélectionnez un nœud visible et non verrouillé : il pourra alors être déplacé</translation>
    </message>
    <message>
        <source>selection</source>
        <translation>la sélection</translation>
    </message>
    <message>
        <source>click or Enter: done · Esc: back · X Y Z: axis (Shift: plane) · digits: value · Ctrl: steps · Shift: fine · Tab: next</source>
        <translation>clic ou Entrée : terminer · Échap : annuler · X Y Z : axe (Maj : plan) · chiffres : valeur · Ctrl : par pas · Maj : fin · Tab : suivant</translation>
    </message>
    <message>
        <source>release: done · Esc: back · X Y Z: axis · digits: value · Ctrl: steps · Shift: fine</source>
        <translation>relâcher : terminer · Échap : annuler · X Y Z : axe · chiffres : valeur · Ctrl : par pas · Maj : fin</translation>
    </message>
    <message>
        <source>drag · Ctrl: steps · Shift: fine · digits: value</source>
        <translation>glisser · Ctrl : par pas · Maj : fin · chiffres : valeur</translation>
    </message>
    <message>
        <source>%1: move, rotate, scale %2</source>
        <translation>%1 : déplacer, tourner, redimensionner %2</translation>
    </message>
</context>
<context>
    <name>ramure::GraftTool</name>
    <message>
        <source>Release: copy this limb · Esc: not this one</source>
        <translation>Lâcher : copier cette branche · Échap : pas celle-là</translation>
    </message>
    <message>
        <source>Release: it grows here · Esc: nowhere</source>
        <translation>Lâcher : elle pousse ici · Échap : nulle part</translation>
    </message>
    <message>
        <source>Click: the copy grows here · Shift + click: copy another limb</source>
        <translation>Clic : la copie pousse ici · Maj + clic : copier une autre branche</translation>
    </message>
    <message>
        <source>Click a limb: copy it</source>
        <translation>Clic sur une branche : la copier</translation>
    </message>
    <message>
        <source>Shift: click copies another limb</source>
        <translation>Maj : un clic copie une autre branche</translation>
    </message>
    <message>
        <source>The limb is copied: click its new place.</source>
        <translation>La branche est copiée : cliquez sur sa nouvelle place.</translation>
    </message>
</context>
<context>
    <name>ramure::GrammarEdit</name>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Replaces lookalikes by the characters of the language</source>
        <translation>Remplace les sosies par les caractères du langage</translation>
    </message>
</context>
<context>
    <name>ramure::GrammarEditor</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(et %n autre)</numerusform>
            <numerusform>(et %n autres)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::GroupSection</name>
    <message>
        <source>Copy, paste or reset this group</source>
        <translation>Copier, coller ou réinitialiser ce groupe</translation>
    </message>
    <message>
        <source>%1: menu</source>
        <translation>%1&#xa0;: menu</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Moins</translation>
    </message>
    <message>
        <source>More…</source>
        <translation>Plus…</translation>
    </message>
    <message>
        <source>Copy values</source>
        <translation>Copier les valeurs</translation>
    </message>
    <message>
        <source>Paste values</source>
        <translation>Coller les valeurs</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) changed</source>
        <translation>
            <numerusform>%n valeur modifiée</numerusform>
            <numerusform>%n valeurs modifiées</numerusform>
        </translation>
    </message>
    <message>
        <source>No value has been changed</source>
        <translation>Aucune valeur n’a été modifiée</translation>
    </message>
    <message>
        <source>Reset values</source>
        <translation>Rétablir les valeurs</translation>
    </message>
</context>
<context>
    <name>ramure::HandActions</name>
    <message>
        <source>Shape &amp;by hand</source>
        <translation>Façonner à la &amp;main</translation>
    </message>
</context>
<context>
    <name>ramure::HandbookWindow</name>
    <message>
        <source>%1 – Handbook of Ramure</source>
        <translation>%1 – Manuel de Ramure</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Aucun résultat</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Retour (Alt+Gauche)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Suivant (Alt+Droite)</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Première page</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>Chercher dans toutes les pages</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
</context>
<context>
    <name>ramure::HeightGrip</name>
    <message>
        <source>Drag to make the box higher or lower; double-click for its usual height</source>
        <translation>Tirer pour agrandir ou réduire la zone ; double-cliquer pour sa hauteur habituelle</translation>
    </message>
</context>
<context>
    <name>ramure::HistoryDock</name>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>Historique des modifications</translation>
    </message>
    <message>
        <source>Click a step to go back or forth to it. The dot marks the saved state.</source>
        <translation>Cliquez une étape pour y revenir ou y avancer. Le point marque l’état enregistré.</translation>
    </message>
</context>
<context>
    <name>ramure::ImportActions</name>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Import folder</source>
        <translation>Importer un dossier</translation>
    </message>
    <message>
        <source>Importing “%1”…</source>
        <translation>Importation de « %1 »…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>“%1” cannot be imported; the scene is as it was.</source>
        <translation>« %1 » ne peut pas être importé ; la scène est inchangée.</translation>
    </message>
    <message>
        <source>“%1” was imported.</source>
        <translation>« %1 » a été importé.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more note(s)</source>
        <translation>
            <numerusform>… et %n autre remarque</numerusform>
            <numerusform>… et %n autres remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Opening “%1”…</source>
        <translation>Ouverture de « %1 »…</translation>
    </message>
    <message>
        <source>“%1” cannot be opened; the scene is as it was.</source>
        <translation>« %1 » ne peut pas être ouvert ; la scène est inchangée.</translation>
    </message>
    <message>
        <source>“%1” was opened.</source>
        <translation>« %1 » a été ouvert.</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Objects, keys and trees (%1)</source>
        <translation>Objets, clés et arbres (%1)</translation>
    </message>
    <message>
        <source>Something stands at its place: it was put %1 m beside it. Undo once puts it where the file has it.</source>
        <translation>Quelque chose se trouve à sa place : il est posé %1 m à côté. Une annulation le remet où le fichier le dit.</translation>
    </message>
</context>
<context>
    <name>ramure::ImportTask</name>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
</context>
<context>
    <name>ramure::IsolationButton</name>
    <message numerus="yes">
        <source>%Ln branch(es) alone</source>
        <translation>
            <numerusform>%Ln branche seule</numerusform>
            <numerusform>%Ln branches seules</numerusform>
        </translation>
    </message>
    <message>
        <source>The branches shown alone are gone</source>
        <translation>Les branches isolées n’existent plus</translation>
    </message>
    <message>
        <source>Only these branches are shown. A click shows the whole tree again.</source>
        <translation>Seules ces branches sont montrées. Un clic montre de nouveau l’arbre entier.</translation>
    </message>
</context>
<context>
    <name>ramure::JobPanel</name>
    <message>
        <source>Give this up; no half-written file stays</source>
        <translation>Abandonner ; aucun fichier inachevé ne reste</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ramure::JointForm</name>
    <message>
        <source>Change joint %1</source>
        <translation>Modifier l&apos;articulation %1</translation>
    </message>
    <message>
        <source>Limit joint %1</source>
        <translation>Limiter l&apos;articulation %1</translation>
    </message>
    <message>
        <source>Limited</source>
        <translation>Limité</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>The angle stays between its limits; otherwise it may turn for ever. Has no keys: key the limits instead, which do</source>
        <translation>L’angle reste entre ses limites&#xa0;; sinon il peut tourner sans fin. N’a pas de clés&#xa0;: animez plutôt les limites, qui en ont</translation>
    </message>
</context>
<context>
    <name>ramure::JointTool</name>
    <message>
        <source>The joint turns · release: done</source>
        <translation>L’articulation tourne · relâcher : terminer</translation>
    </message>
    <message>
        <source>Drag: turn the joint</source>
        <translation>Glisser : tourner l’articulation</translation>
    </message>
    <message>
        <source>Turn joint %1</source>
        <translation>Tourner l&apos;articulation %1</translation>
    </message>
</context>
<context>
    <name>ramure::KeepTool</name>
    <message>
        <source>Click: all goes but this limb</source>
        <translation>Clic : tout s’en va sauf cette branche</translation>
    </message>
    <message>
        <source>Release: all goes but this limb · Esc: all stays</source>
        <translation>Lâcher : tout s’en va sauf cette branche · Échap : tout reste</translation>
    </message>
</context>
<context>
    <name>ramure::KeptForm</name>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>kept settings, or a name for these</source>
        <translation>nom de réglages à garder</translation>
    </message>
    <message>
        <source>Settings of this page under a name, or those of its last export. The folder of the files is not part of them.</source>
        <translation>Réglages de cette page gardés sous un nom, ou ceux de son dernier export. Le dossier des fichiers n’en fait pas partie.</translation>
    </message>
    <message>
        <source>As the last time</source>
        <translation>Comme la dernière fois</translation>
    </message>
    <message>
        <source>Keeps the choices of this page under this name</source>
        <translation>Garde les choix de cette page sous ce nom</translation>
    </message>
    <message>
        <source>Type a name first; the choices of this page are kept under it</source>
        <translation>Tapez d’abord un nom ; les choix de cette page seront gardés sous celui-ci</translation>
    </message>
    <message>
        <source>Forgets the settings of this name</source>
        <translation>Oublie les réglages de ce nom</translation>
    </message>
    <message>
        <source>No kept settings are chosen</source>
        <translation>Aucun réglage gardé n’est choisi</translation>
    </message>
    <message>
        <source>Nothing was exported from this page yet.</source>
        <translation>Rien n’a encore été exporté depuis cette page.</translation>
    </message>
    <message>
        <source>Kept as “%1”.</source>
        <translation>Gardé sous « %1 ».</translation>
    </message>
</context>
<context>
    <name>ramure::KeyActions</name>
    <message>
        <source>Easings</source>
        <translation>Accélérations</translation>
    </message>
    <message>
        <source>End of the segment on which the easing acts</source>
        <translation>Bout du segment où agit l’accélération</translation>
    </message>
    <message>
        <source>Position of the handles of Bézier keys</source>
        <translation>Position des poignées des clés de Bézier</translation>
    </message>
    <message>
        <source>Before the first key</source>
        <translation>Avant la première clé</translation>
    </message>
    <message>
        <source>Behind the last key</source>
        <translation>Après la dernière clé</translation>
    </message>
    <message>
        <source>For every channel with a selected key</source>
        <translation>Pour chaque canal ayant une clé sélectionnée</translation>
    </message>
</context>
<context>
    <name>ramure::KeyCommands</name>
    <message>
        <source>No key is selected.</source>
        <translation>Aucune clé n’est sélectionnée.</translation>
    </message>
    <message>
        <source>Select a node first: it gets the key.</source>
        <translation>Sélectionnez d’abord un nœud : il reçoit la clé.</translation>
    </message>
    <message>
        <source>The selected nodes have no keys yet.</source>
        <translation>Les nœuds sélectionnés n’ont pas encore de clés.</translation>
    </message>
    <message>
        <source>The selected nodes have no key at this frame.</source>
        <translation>Les nœuds sélectionnés n’ont pas de clé à cette image.</translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) copied</source>
        <translation>
            <numerusform>%n clé copiée</numerusform>
            <numerusform>%n clés copiées</numerusform>
        </translation>
    </message>
    <message>
        <source>No keys have been copied.</source>
        <translation>Aucune clé n’a été copiée.</translation>
    </message>
    <message>
        <source>Mirror Keys</source>
        <translation>Mettre des clés en miroir</translation>
    </message>
    <message>
        <source>Snap Keys to Seconds</source>
        <translation>Aligner des clés sur les secondes</translation>
    </message>
    <message>
        <source>Snap Keys to Frames</source>
        <translation>Aligner des clés sur les images</translation>
    </message>
    <message>
        <source>Move Keys</source>
        <translation>Déplacer des clés</translation>
    </message>
    <message>
        <source>Scale Keys</source>
        <translation>Étirer des clés</translation>
    </message>
    <message>
        <source>Change Interpolation</source>
        <translation>Changer l’interpolation</translation>
    </message>
    <message>
        <source>Change Easing</source>
        <translation>Changer l’accélération</translation>
    </message>
    <message>
        <source>Change Handles</source>
        <translation>Changer les poignées</translation>
    </message>
    <message>
        <source>There is no key behind this frame.</source>
        <translation>Il n’y a pas de clé après cette image.</translation>
    </message>
    <message>
        <source>There is no key before this frame.</source>
        <translation>Il n’y a pas de clé avant cette image.</translation>
    </message>
    <message>
        <source>Drag Handle</source>
        <translation>Glisser une poignée</translation>
    </message>
</context>
<context>
    <name>ramure::KeyCurves</name>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Drag the handle: how the curve leaves the key, or comes to it</source>
        <translation>Glisser la poignée : comment la courbe quitte la clé, ou y arrive</translation>
    </message>
    <message>
        <source>Frame %1, %2 s</source>
        <translation>Image %1, %2 s</translation>
    </message>
    <message>
        <source>without unit</source>
        <translation>sans unité</translation>
    </message>
    <message>
        <source>Values: %1</source>
        <translation>Valeurs : %1</translation>
    </message>
</context>
<context>
    <name>ramure::KeyPanel</name>
    <message numerus="yes">
        <source>%n key(s) selected</source>
        <translation>
            <numerusform>%n clé sélectionnée</numerusform>
            <numerusform>%n clés sélectionnées</numerusform>
        </translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>How the value goes from each selected key to the next</source>
        <translation>Comment la valeur va de chaque clé sélectionnée à la suivante</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>At which end the easings of the selected keys show their character</source>
        <translation>À quel bout les accélérations des clés sélectionnées montrent leur caractère</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Poignées</translation>
    </message>
    <message>
        <source>Position of the handles of the selected Bézier keys</source>
        <translation>Position des poignées des clés de Bézier sélectionnées</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extrémités</translation>
    </message>
    <message>
        <source>Values of the channels before their first key and after their last</source>
        <translation>Valeurs des canaux avant leur première clé et après leur dernière</translation>
    </message>
    <message>
        <source>All nodes</source>
        <translation>Tous les nœuds</translation>
    </message>
    <message>
        <source>Show the keys of all nodes, not only of those selected in the scene</source>
        <translation>Montrer les clés de tous les nœuds, pas seulement de ceux sélectionnés dans la scène</translation>
    </message>
    <message>
        <source>Snap to</source>
        <translation>Aligner sur</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>Snapping of dragged keys; hold Shift to drag freely</source>
        <translation>Aimantation des clés glissées ; tenir Maj pour glisser librement</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Alignement</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Show the values over time instead of the dope sheet</source>
        <translation>Montrer les valeurs dans le temps à la place de la feuille de clés</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normaliser</translation>
    </message>
    <message>
        <source>Every curve over the same height, whatever its values</source>
        <translation>Chaque courbe sur la même hauteur, quelles que soient ses valeurs</translation>
    </message>
    <message>
        <source>No keys here. Select a node and press I to insert keys of its position, rotation and scale at the frame on show.</source>
        <translation>Pas de clés ici. Sélectionnez un nœud et appuyez sur I pour insérer des clés de position, rotation et échelle à l’image affichée.</translation>
    </message>
</context>
<context>
    <name>ramure::KeyRowList</name>
    <message>
        <source>All keys</source>
        <translation>Toutes les clés</translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n clé</numerusform>
            <numerusform>%n clés</numerusform>
        </translation>
    </message>
    <message>
        <source>Click selects all of them, Shift+click adds; the triangle folds.</source>
        <translation>Un clic les sélectionne toutes, Maj+clic ajoute ; le triangle replie.</translation>
    </message>
    <message>
        <source>Show or hide this curve</source>
        <translation>Montrer ou masquer cette courbe</translation>
    </message>
    <message>
        <source>Click selects all of them, Shift+click adds.</source>
        <translation>Un clic les sélectionne toutes, Maj+clic ajoute.</translation>
    </message>
</context>
<context>
    <name>ramure::KeySheet</name>
    <message>
        <source>Dope sheet</source>
        <translation>Feuille de clés</translation>
    </message>
    <message>
        <source>Drag to scale the selected keys in time; Shift: without snapping</source>
        <translation>Glisser pour étirer les clés sélectionnées dans le temps ; Maj : sans alignement</translation>
    </message>
    <message>
        <source>Frame %1, %2 s</source>
        <translation>Image %1, %2 s</translation>
    </message>
</context>
<context>
    <name>ramure::KeyValues</name>
    <message>
        <source>Change Key Values</source>
        <translation>Changer des valeurs de clés</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Value of the selected keys: metres, a factor, the parameter&apos;s unit, or degrees about %1</source>
        <translation>Valeur des clés sélectionnées : mètres, un facteur, l’unité du paramètre, ou degrés autour de %1</translation>
    </message>
    <message>
        <source>Key value %1</source>
        <translation>Valeur de clé %1</translation>
    </message>
</context>
<context>
    <name>ramure::LeafDialog</name>
    <message>
        <source>Leaves of “%1”</source>
        <translation>Feuilles de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Drag: turn · wheel: nearer · the properties shape the leaf</source>
        <translation>Glisser : tourner · molette : rapprocher · les propriétés façonnent la feuille</translation>
    </message>
</context>
<context>
    <name>ramure::LeafView</name>
    <message>
        <source>One leaf, and a twig with its leaves</source>
        <translation>Une feuille, et un rameau avec les siennes</translation>
    </message>
    <message>
        <source>Drag or arrow keys: turn · wheel, + and −: nearer or farther · Home: from the front</source>
        <translation>Glisser ou touches fléchées : tourner · molette, + et − : rapprocher ou éloigner · Début : de face</translation>
    </message>
</context>
<context>
    <name>ramure::LeavesTool</name>
    <message>
        <source>Click: the leaves of the limb go; once more: they come back</source>
        <translation>Clic : les feuilles de la branche s’en vont ; encore une fois : elles reviennent</translation>
    </message>
    <message>
        <source>Release: leaves off or on · Esc: as they were</source>
        <translation>Lâcher : feuilles ou non · Échap : comme elles étaient</translation>
    </message>
</context>
<context>
    <name>ramure::LensForm</name>
    <message>
        <source>&amp;Depth of field</source>
        <translation>&amp;Profondeur de champ</translation>
    </message>
    <message>
        <source>Antialiasing samples of each pixel, 1 to 256: finer edges, and as many times slower. Depth of field draws 32 or more</source>
        <translation>Échantillons d’anticrénelage par pixel, de 1 à 256 : des bords plus fins, et autant de fois plus lent. La profondeur de champ en dessine 32 ou plus</translation>
    </message>
    <message>
        <source>A parallel view has no depth of field: everything is sharp</source>
        <translation>Une vue parallèle n’a pas de profondeur de champ : tout est net</translation>
    </message>
    <message>
        <source>Blurs what is nearer or farther than the focus, as the lens of a camera does. The picture takes 32 times as long</source>
        <translation>Rend flou ce qui est plus près ou plus loin que la mise au point, comme l’objectif d’un appareil. L’image prend 32 fois plus de temps</translation>
    </message>
    <message>
        <source>f/</source>
        <translation>f/</translation>
    </message>
    <message>
        <source>Opening of the lens before a film of 24 mm, 0.1 to 64: the smaller the number, the more is blurred</source>
        <translation>Ouverture de l’objectif devant un film de 24 mm, de 0,1 à 64 : plus le nombre est petit, plus le flou est fort</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>what the camera looks at (%1 m)</source>
        <translation>ce que la caméra regarde (%1 m)</translation>
    </message>
    <message>
        <source>Distance from the camera, in metres, at which everything is sharp; 0: what the camera looks at</source>
        <translation>Distance à la caméra, en mètres, où tout est net ; 0 : ce que la caméra regarde</translation>
    </message>
    <message>
        <source>Hides this dialog until you click what is to be sharp</source>
        <translation>Cache ce dialogue jusqu’à ce que vous cliquiez sur ce qui doit être net</translation>
    </message>
    <message>
        <source>Samples &amp;per pixel</source>
        <translation>&amp;Échantillons par pixel</translation>
    </message>
    <message>
        <source>F-&amp;stop</source>
        <translation>&amp;Ouverture</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Mise au point</translation>
    </message>
    <message>
        <source>Pick the focus in the &amp;view…</source>
        <translation>Choisir la mise au point dans la &amp;vue…</translation>
    </message>
</context>
<context>
    <name>ramure::LevelForm</name>
    <message>
        <source>Meshes of each tree, 1 to 8, for less and less triangles. A GLB holds them all; of other formats each is a file.</source>
        <translation>Maillages de chaque arbre, de 1 à 8, de moins en moins de triangles. Un GLB les contient tous ; dans les autres formats, chacun est un fichier.</translation>
    </message>
    <message>
        <source>Number of levels</source>
        <translation>Nombre de niveaux</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Triangles of each level</source>
        <translation>Triangles de chaque niveau</translation>
    </message>
    <message>
        <source>From</source>
        <translation>À partir de</translation>
    </message>
    <message>
        <source>60 %, then half of it each</source>
        <translation>60 %, puis la moitié</translation>
    </message>
    <message>
        <source>60 % of the picture&apos;s height, then half of it each</source>
        <translation>60 % de la hauteur de l’image, puis la moitié</translation>
    </message>
    <message>
        <source>When each level but the first takes the place of the one before. Metres from the eye, rising, such as 20; 60, for a vertical angle of view of 40°. Or shares of the picture&apos;s height that the tree has, falling, such as 60 %; 30 %, as engines have them: they suit a tree of any size. Nothing here: 60 %, then half of it each.</source>
        <translation>Quand chaque niveau sauf le premier remplace le précédent. Des mètres depuis l’œil, croissants, comme 20; 60, pour un angle de vue vertical de 40°. Ou des parts de la hauteur de l’image que l’arbre occupe, décroissantes, comme 60 %; 30 %, comme dans les moteurs de jeu : elles conviennent à un arbre de toute taille. Rien ici : 60 %, puis chaque fois la moitié.</translation>
    </message>
    <message>
        <source>When each level is shown</source>
        <translation>Quand chaque niveau se montre</translation>
    </message>
    <message>
        <source>as it is, then a quarter or less</source>
        <comment>the tree</comment>
        <translation>tel quel, puis ≤ un quart</translation>
    </message>
    <message>
        <source>the tree as it is, then a quarter or less each</source>
        <translation>l’arbre tel quel, puis un quart ou moins</translation>
    </message>
    <message>
        <source>Triangles of each level, with commas between them, such as 10000, 2500: bark, leaves and fruit together, kept within 2 %. Nothing here: the first level is the tree as it is, each further one has a quarter of the one before; less, often an eighth, where its bark would keep more than half of its triangles, as in a tree full of leaves.</source>
        <translation>Triangles de chaque niveau, séparés par des virgules, par exemple 10000, 2500 : écorce, feuilles et fruits ensemble, à 2 % près. Rien ici : le premier niveau est l’arbre tel quel, chaque niveau suivant a un quart du précédent ; moins, souvent un huitième, là où son écorce garderait plus de la moitié de ses triangles, comme dans un arbre plein de feuilles.</translation>
    </message>
    <message>
        <source>Twigs as pictures on cards</source>
        <translation>Rameaux en images sur des cartes</translation>
    </message>
    <message>
        <source>Where not all leaves are there, crossed cards show pictures of this tree&apos;s own twigs in the place of fewer and larger leaves: outlines stay, and the picture needs its opacity. For GLB and OBJ with pictures, and leaves without pictures of their own.</source>
        <translation>Là où il n’y a pas toutes les feuilles, des cartes croisées montrent des images des rameaux de cet arbre à la place de feuilles moins nombreuses et plus grandes : les contours restent, et l’image a besoin de son opacité. Pour les GLB et OBJ avec images, et les feuilles sans images à elles.</translation>
    </message>
    <message>
        <source>A billboard as the last level</source>
        <translation>Un billboard comme dernier niveau</translation>
    </message>
    <message>
        <source>One level more, for trees that are far away: three crossed cards with pictures of the whole tree, six triangles, in the place of bark, leaves and fruit. For GLB and OBJ with pictures.</source>
        <translation>Un niveau de plus, pour les arbres lointains : trois cartes croisées avec des images de l’arbre entier, six triangles, à la place de l’écorce, des feuilles et des fruits. Pour GLB et OBJ avec images.</translation>
    </message>
</context>
<context>
    <name>ramure::LevelModel</name>
    <message>
        <source>%1 %</source>
        <comment>a share</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 m</source>
        <comment>metres</comment>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>The finest level</source>
        <translation>Le niveau le plus fin</translation>
    </message>
    <message>
        <source>%1 of %2 leaves, %3 times as large</source>
        <translation>%1 feuilles sur %2, %3 fois plus grandes</translation>
    </message>
    <message>
        <source>Number of the level, the finest first, as in the names of the export</source>
        <translation>Numéro du niveau, le plus fin d’abord, comme dans les noms de l’export</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niv.</translation>
    </message>
    <message>
        <source>Triangles of bark, leaves and fruit together</source>
        <translation>Triangles de l’écorce, des feuilles et des fruits ensemble</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Triangles of the bark, which is one closed mesh</source>
        <translation>Triangles de l’écorce, qui est un seul maillage fermé</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Écorce</translation>
    </message>
    <message>
        <source>Triangles of leaves and fruit</source>
        <translation>Triangles des feuilles et des fruits</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Share of the tree&apos;s leaves that are left; they have grown, so that the crown keeps its area</source>
        <translation>Part des feuilles de l’arbre qui restent&#xa0;; elles ont grandi, si bien que le houppier garde sa surface</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Dès</translation>
    </message>
    <message>
        <source>Takes the place of level %1 from %2 on, where the tree has %3 of the picture&apos;s height. The details in which they differ, %4 mm, are one pixel of a screen 1080 pixels high from %5 on.</source>
        <translation>Remplace le niveau %1 à partir de %2, où l’arbre occupe %3 de la hauteur de l’image. Les détails qui les distinguent, %4 mm, font un pixel d’un écran haut de 1080 pixels à partir de %5.</translation>
    </message>
    <message>
        <source>A GLB says that it is needed while the tree covers %1 of the screen or more (MSFT_screencoverage).</source>
        <translation>Un GLB dit qu’il est nécessaire tant que l’arbre couvre %1 de l’écran ou plus (MSFT_screencoverage).</translation>
    </message>
    <message>
        <source>Distance in metres from which the level takes the place of the one before, with a vertical angle of view of 40°. Double-click one to change it.</source>
        <translation>Distance en mètres à partir de laquelle le niveau remplace le précédent, pour un angle de vue vertical de 40°. Un double-clic la change.</translation>
    </message>
    <message>
        <source>Share of the picture&apos;s height that the tree has there, whatever the angle of view. Double-click one to change it.</source>
        <translation>Part de la hauteur de l’image que l’arbre y occupe, quel que soit l’angle de vue. Un double-clic la change.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Leaves
left</source>
        <translation>Feuilles
restantes</translation>
    </message>
    <message>
        <source>A billboard: crossed cards with pictures of the whole tree</source>
        <translation>Un billboard : des cartes croisées avec des images de l’arbre entier</translation>
    </message>
</context>
<context>
    <name>ramure::LevelView</name>
    <message>
        <source>Drag or arrow keys: turn · wheel, + and −: nearer or farther · Home: from the front</source>
        <translation>Glisser ou flèches&#xa0;: tourner · molette, + et −&#xa0;: plus près ou plus loin · Début&#xa0;: de face</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Dessin…</translation>
    </message>
</context>
<context>
    <name>ramure::LevelsPanel</name>
    <message>
        <source>Level %1
%2 triangles</source>
        <translation>Niveau %1
%2 triangles</translation>
    </message>
    <message>
        <source>Whole tree
%1 triangles</source>
        <translation>Arbre entier
%1 triangles</translation>
    </message>
    <message>
        <source>Select a tree: its levels of detail are shown here as a game shows them, before they are exported.</source>
        <translation>Choisissez un arbre&#xa0;: ses niveaux de détail sont montrés ici comme un jeu les montre, avant l’export.</translation>
    </message>
    <message>
        <source>The tree is growing…</source>
        <translation>L’arbre pousse…</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Go to its &amp;distance</source>
        <translation>Aller à sa &amp;distance</translation>
    </message>
    <message>
        <source>&amp;Copy the figures</source>
        <translation>&amp;Copier les chiffres</translation>
    </message>
    <message>
        <source>Copy the whole &amp;table</source>
        <translation>Copier tout le &amp;tableau</translation>
    </message>
    <message>
        <source>&amp;Export these levels…</source>
        <translation>&amp;Exporter ces niveaux…</translation>
    </message>
    <message>
        <source>Export a tree of %1 t&amp;riangles alone…</source>
        <translation>Exporter un seul arbre de %1 t&amp;riangles…</translation>
    </message>
    <message numerus="yes">
        <source>Copied %Ln level(s)</source>
        <translation>
            <numerusform>%Ln niveau copié</numerusform>
            <numerusform>%Ln niveaux copiés</numerusform>
        </translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Making the levels</source>
        <translation>Calcul des niveaux</translation>
    </message>
    <message>
        <source>Give this up</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Make the levels</source>
        <translation>Calculer les niveaux</translation>
    </message>
    <message>
        <source>Begins again with the tree as it is now</source>
        <translation>Recommence avec l’arbre tel qu’il est maintenant</translation>
    </message>
    <message>
        <source>Levels of detail</source>
        <translation>Niveaux de détail</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>From the eye to the tree, in metres: a game shows the level that takes over before it. Arrow keys: a tenth nearer or farther</source>
        <translation>De l’œil à l’arbre, en mètres&#xa0;: un jeu montre le dernier niveau qui a pris le relais. Flèches&#xa0;: un dixième plus près ou plus loin</translation>
    </message>
    <message>
        <source>The level from this distance</source>
        <translation>Le niveau vu de cette distance</translation>
    </message>
    <message>
        <source>The whole tree from this distance</source>
        <translation>L’arbre entier vu de cette distance</translation>
    </message>
    <message>
        <source>Zoom to the tree</source>
        <translation>Zoom sur l’arbre</translation>
    </message>
    <message>
        <source>Shows both as through a long lens, to compare their shapes; else they have the pixels of a screen 1080 pixels high</source>
        <translation>Montre les deux comme au téléobjectif, pour comparer leurs formes&#xa0;; sinon, ils ont les pixels d’un écran haut de 1080 pixels</translation>
    </message>
    <message>
        <source>Export these levels…</source>
        <translation>Exporter ces niveaux…</translation>
    </message>
    <message>
        <source>Opens the export for a game with these levels</source>
        <translation>Ouvre l’export pour un jeu avec ces niveaux</translation>
    </message>
    <message>
        <source>A screen 1080 pixels high, with the view&apos;s angle of view, 40°</source>
        <translation>Un écran haut de 1080 pixels, avec l’angle de la vue, 40°</translation>
    </message>
    <message>
        <source>At %1 the tree is %2 pixels high on a screen of 1080.</source>
        <translation>À %1, l’arbre fait %2 pixels de haut sur un écran de 1080.</translation>
    </message>
    <message>
        <source>Double-click a distance or a height to change it.</source>
        <translation>Un double-clic sur une distance ou une hauteur la change.</translation>
    </message>
</context>
<context>
    <name>ramure::LightDialog</name>
    <message>
        <source>Light and backdrop</source>
        <translation>Lumière et fond</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Paysage</translation>
    </message>
    <message>
        <source>Light studio</source>
        <translation>Studio clair</translation>
    </message>
    <message>
        <source>Dark studio</source>
        <translation>Studio sombre</translation>
    </message>
    <message>
        <source>Direction of the sun, in degrees clockwise from the north (−Z): 90 is the east (X)</source>
        <translation>Direction du soleil, en degrés dans le sens des aiguilles d’une montre depuis le nord (−Z) : 90 est l’est (X)</translation>
    </message>
    <message>
        <source>Height of the sun over the horizon, 2 to 90 degrees: a low one is warm</source>
        <translation>Hauteur du soleil au-dessus de l’horizon, de 2 à 90 degrés : un soleil bas est chaud</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>&amp;Backdrop</source>
        <translation>&amp;Fond</translation>
    </message>
    <message>
        <source>Sun &amp;from</source>
        <translation>Soleil &amp;depuis</translation>
    </message>
    <message>
        <source>Sun &amp;height</source>
        <translation>&amp;Hauteur du soleil</translation>
    </message>
    <message>
        <source>Usual light</source>
        <translation>Lumière habituelle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Then the sun stands at %1°, %2° high.</source>
        <translation>Le soleil se trouve alors à %1°, à %2° de hauteur.</translation>
    </message>
    <message>
        <source>Then the sun is below the horizon, or less than %1° above it.</source>
        <translation>Le soleil est alors sous l’horizon, ou à moins de %1° au-dessus.</translation>
    </message>
    <message>
        <source>Natural sky</source>
        <translation>Ciel naturel</translation>
    </message>
    <message>
        <source>Dust and water in the air of the natural sky: 2 is very clear, 8 hazy</source>
        <translation>Poussière et eau dans l’air du ciel naturel : 2 est très clair, 8 brumeux</translation>
    </message>
    <message>
        <source>Brighter or darker by so many f-stops: 1 is twice the light</source>
        <translation>Plus clair ou plus sombre d’autant de diaphragmes : 1 double la lumière</translation>
    </message>
    <message>
        <source> stops</source>
        <translation> IL</translation>
    </message>
    <message>
        <source>Ha&amp;ze</source>
        <translation>Br&amp;ume</translation>
    </message>
    <message>
        <source>E&amp;xposure</source>
        <translation>E&amp;xposition</translation>
    </message>
    <message>
        <source>The sun of a day and a place</source>
        <translation>Le soleil d’un jour et d’un lieu</translation>
    </message>
    <message>
        <source>Day and time, in this computer&apos;s time zone</source>
        <translation>Jour et heure, dans le fuseau horaire de cet ordinateur</translation>
    </message>
    <message>
        <source>Degrees north of the equator; south of it negative</source>
        <translation>Degrés au nord de l’équateur ; négatif au sud</translation>
    </message>
    <message>
        <source>Degrees east of Greenwich; west of it negative</source>
        <translation>Degrés à l’est de Greenwich ; négatif à l’ouest</translation>
    </message>
    <message>
        <source>&amp;Day and time</source>
        <translation>&amp;Jour et heure</translation>
    </message>
    <message>
        <source>&amp;Latitude</source>
        <translation>&amp;Latitude</translation>
    </message>
    <message>
        <source>L&amp;ongitude</source>
        <translation>L&amp;ongitude</translation>
    </message>
    <message>
        <source>&amp;Put the sun there</source>
        <translation>&amp;Placer le soleil ainsi</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Choisir…</translation>
    </message>
    <message>
        <source>Sky picture</source>
        <translation>Image du ciel</translation>
    </message>
    <message>
        <source>Background of the trees: sky and meadow, the physical sky and light of a clear day for the sun&apos;s height, one colour that takes shadows, or an own picture all around that gives the light and the sun</source>
        <translation>Fond des arbres : ciel et prairie, le ciel et la lumière physiques d’un jour clair selon la hauteur du soleil, une couleur unie qui reçoit les ombres, ou une image à vous tout autour, qui donne la lumière et le soleil</translation>
    </message>
    <message>
        <source>A linear picture all around (HDR or EXR), twice as wide as high, whose brightest spot is the sun</source>
        <translation>Une image linéaire tout autour (HDR ou EXR), deux fois plus large que haute, dont la tache la plus claire est le soleil</translation>
    </message>
    <message>
        <source>Pict&amp;ure</source>
        <translation>&amp;Image</translation>
    </message>
    <message>
        <source>&amp;Turned by</source>
        <translation>&amp;Tournée de</translation>
    </message>
    <message>
        <source>Turns the picture and its sun around the vertical, in degrees clockwise seen from above</source>
        <translation>Tourne l’image et son soleil autour de la verticale, en degrés dans le sens des aiguilles d’une montre vu d’en haut</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source> K</source>
        <translation> K</translation>
    </message>
    <message>
        <source>&amp;White balance</source>
        <translation>&amp;Balance des blancs</translation>
    </message>
    <message>
        <source>The light that the picture shows as white, in kelvin, as a camera has it: 6500 changes nothing, less makes the picture bluer, more makes it warmer</source>
        <translation>La lumière que l’image montre blanche, en kelvins, comme sur un appareil photo : 6500 ne change rien, moins rend l’image plus bleue, plus la rend plus chaude</translation>
    </message>
</context>
<context>
    <name>ramure::LimbTool</name>
    <message>
        <source>The limb and its thick branches follow · wheel: how many branches · Esc: back</source>
        <translation>La branche maîtresse et ses branches épaisses suivent · molette : combien de branches · Échap : annuler</translation>
    </message>
    <message>
        <source>The limb follows · wheel: how many branches · Shift: trunk and root, too · Esc: back</source>
        <translation>La branche maîtresse suit · molette : combien de branches · Maj : tronc et racine aussi · Échap : annuler</translation>
    </message>
    <message>
        <source>Ctrl + drag: bend the limb</source>
        <translation>Ctrl + glisser : plier la branche maîtresse</translation>
    </message>
    <message>
        <source>Ctrl: drag bends the limb (with Shift: trunk and root, too)</source>
        <translation>Ctrl : glisser plie la branche maîtresse (avec Maj : tronc et racine aussi)</translation>
    </message>
    <message numerus="yes">
        <source>%n branch(es) follow</source>
        <translation>
            <numerusform>%n branche suit</numerusform>
            <numerusform>%n branches suivent</numerusform>
        </translation>
    </message>
    <message>
        <source>The root stays; with Shift it follows</source>
        <translation>La racine reste ; avec Maj elle suit</translation>
    </message>
    <message>
        <source>out of reach: %1 m short</source>
        <translation>hors d&apos;atteinte : il manque %1 m</translation>
    </message>
    <message>
        <source>At some places around the trunk no limb is like it: nothing happens there.</source>
        <translation>À certains endroits autour du tronc, aucune branche ne lui ressemble : il ne s’y passe rien.</translation>
    </message>
</context>
<context>
    <name>ramure::MainWindow</name>
    <message>
        <source>Exported to %1</source>
        <translation>Exporté vers %1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>He&amp;lp</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Barre d’outils</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>Validation</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Sélection</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>There is no tree in the scene.</source>
        <translation>Il n’y a pas d’arbre dans la scène.</translation>
    </message>
    <message>
        <source>Baking the motion</source>
        <translation>Précalcul du mouvement</translation>
    </message>
    <message numerus="yes">
        <source>Writing %Ln file(s)</source>
        <translation>
            <numerusform>Écriture de %Ln fichier</numerusform>
            <numerusform>Écriture de %Ln fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>The export was cancelled; the files written so far are whole</source>
        <translation>L’export est annulé ; les fichiers déjà écrits sont entiers</translation>
    </message>
    <message>
        <source>The export has ended with an error; the files written before it are whole.</source>
        <translation>L’export s’est arrêté sur une erreur ; les fichiers écrits auparavant sont entiers.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln file(s) written to %1</source>
        <translation>
            <numerusform>%Ln fichier écrit dans %1</numerusform>
            <numerusform>%Ln fichiers écrits dans %1</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Clés</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Clés</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Baking the arm to keys</source>
        <translation>Transformation du bras en clés</translation>
    </message>
    <message>
        <source>Putting the mesh on the arm</source>
        <translation>Mise du maillage sur le bras</translation>
    </message>
    <message>
        <source>The preferences cannot be stored. They hold until the program ends.</source>
        <translation>Les préférences ne peuvent pas être enregistrées. Elles valent jusqu’à la fin du programme.</translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation>Galerie</translation>
    </message>
    <message>
        <source>Let go: “%1” becomes this tree</source>
        <translation>Lâchez : « %1 » devient cet arbre</translation>
    </message>
    <message>
        <source>Let go: plant it here</source>
        <translation>Lâchez : le planter ici</translation>
    </message>
    <message>
        <source>Let go: plant it where there is room</source>
        <translation>Lâchez : le planter là où il y a de la place</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Exported to %1 (%2)</source>
        <translation>Exporté vers %1 (%2)</translation>
    </message>
    <message>
        <source>The folder %1 cannot be shown</source>
        <translation>Le dossier %1 ne peut pas être montré</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Drawing a picture</source>
        <translation>Dessin d’une image</translation>
    </message>
    <message>
        <source>Drawing a billboard</source>
        <translation>Dessin d’un billboard</translation>
    </message>
    <message>
        <source>The oldest steps can no longer be undone: all steps together held more than %1 of memory.</source>
        <translation>Les étapes les plus anciennes ne peuvent plus être annulées : toutes ensemble occupaient plus de %1 de mémoire.</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Reading a sky picture</source>
        <translation>Lecture d’une image du ciel</translation>
    </message>
</context>
<context>
    <name>ramure::MeasureTool</name>
    <message>
        <source>Click: the tape begins here · drag: from here to there · Esc: lay it down</source>
        <translation>Clic : le ruban commence ici · glisser : d’ici à là · Échap : le poser</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 · height %2 · across %3</source>
        <translation>%1 · hauteur %2 · à plat %3</translation>
    </message>
    <message>
        <source>%1 · release: the tape stays · Esc: no tape</source>
        <translation>%1 · relâcher : le ruban reste · Échap : pas de ruban</translation>
    </message>
    <message>
        <source>Click: the tape ends here</source>
        <translation>Clic : le ruban finit ici</translation>
    </message>
    <message>
        <source>diameter %1 cm</source>
        <translation>diamètre %1 cm</translation>
    </message>
</context>
<context>
    <name>ramure::MenuSearch</name>
    <message>
        <source>Type to find</source>
        <translation>Tapez pour chercher</translation>
    </message>
    <message>
        <source>Find in this menu</source>
        <translation>Chercher dans ce menu</translation>
    </message>
    <message>
        <source>Nothing here is called that</source>
        <translation>Rien ici ne s’appelle ainsi</translation>
    </message>
</context>
<context>
    <name>ramure::MenuTool</name>
    <message>
        <source>right: menu</source>
        <translation>droite : menu</translation>
    </message>
</context>
<context>
    <name>ramure::MessageBanner</name>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>ramure::MomentForm</name>
    <message>
        <source>At rest, as at frame 0</source>
        <translation>Au repos, comme à l’image 0</translation>
    </message>
    <message>
        <source>The frame on show, %1</source>
        <translation>L’image affichée, %1</translation>
    </message>
    <message>
        <source>A sequence of frames</source>
        <translation>Une suite d’images</translation>
    </message>
    <message>
        <source>A turn around the tree (pictures)</source>
        <translation>Un tour de l’arbre (images PNG)</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Instant</translation>
    </message>
    <message>
        <source>First frame that is written</source>
        <translation>Première image écrite</translation>
    </message>
    <message>
        <source>Last frame that is written</source>
        <translation>Dernière image écrite</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>every</source>
        <translation>toutes les</translation>
    </message>
    <message>
        <source>Frames from one file to the next: 1 writes all</source>
        <translation>Images d’un fichier au suivant : 1 les écrit toutes</translation>
    </message>
    <message>
        <source>at %1 fps</source>
        <translation>à %1 i/s</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> images</translation>
    </message>
    <message>
        <source>Pictures all around</source>
        <translation>Images tout autour</translation>
    </message>
    <message>
        <source>Pictures all around, 2 to 10000, from the slope of the view and as near as the whole crown allows</source>
        <translation>Images tout autour, de 2 à 10000, sous l&apos;inclinaison de la vue et d&apos;aussi près que le permet toute la couronne</translation>
    </message>
    <message>
        <source>A loop of wind without a seam (GLB)</source>
        <translation>Une boucle de vent sans raccord (GLB)</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length of the loop in seconds, 0.1 to 60: the last frame is the first one again, and the motion goes on without a seam</source>
        <translation>Durée de la boucle en secondes, de 0,1 à 60 : la dernière image est de nouveau la première, et le mouvement continue sans raccord</translation>
    </message>
    <message>
        <source>Length of the loop</source>
        <translation>Durée de la boucle</translation>
    </message>
</context>
<context>
    <name>ramure::MoveTool</name>
    <message>
        <source>Digits: place in % · wheel: around · Enter or click: done · Esc: back</source>
        <translation>Chiffres : place en % · molette : autour · Entrée ou clic : fait · Échap : retour</translation>
    </message>
    <message>
        <source>Release: done · Shift or wheel: around · Ctrl: onto another branch · digits: place in % · Esc: back</source>
        <translation>Lâcher : fait · Maj ou molette : autour · Ctrl : sur une autre branche · chiffres : place en % · Échap : retour</translation>
    </message>
    <message>
        <source>Drag a branch: its fork slides along its parent</source>
        <translation>Glissez une branche : sa fourche glisse le long de son parent</translation>
    </message>
    <message>
        <source>Click: type its place</source>
        <translation>Clic : taper sa place</translation>
    </message>
    <message>
        <source>at %1 % · %2°</source>
        <translation>à %1 % · %2°</translation>
    </message>
    <message>
        <source>at %1 %</source>
        <translation>à %1 %</translation>
    </message>
    <message>
        <source> · type a number</source>
        <translation> · tapez un nombre</translation>
    </message>
</context>
<context>
    <name>ramure::NavigationCube</name>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
</context>
<context>
    <name>ramure::NavigationTool</name>
    <message>
        <source>The view moves · release: done</source>
        <translation>La vue se déplace · relâcher : terminer</translation>
    </message>
    <message>
        <source>Down or left: farther · up or right: nearer · release: done</source>
        <translation>Bas ou gauche : plus loin · haut ou droite : plus près · relâcher : terminer</translation>
    </message>
    <message>
        <source>The view turns · release: done</source>
        <translation>La vue tourne · relâcher : terminer</translation>
    </message>
    <message>
        <source>Alt: drag turns (with Shift: moves, with Ctrl: zooms) · middle: moves · right: zooms</source>
        <translation>Alt : glisser tourne (avec Maj : déplace, avec Ctrl : zoome) · milieu : déplace · droite : zoome</translation>
    </message>
    <message>
        <source>Alt: drag turns (with Shift: moves, with Ctrl: zooms) · right: zooms</source>
        <translation>Alt : glisser tourne (avec Maj : déplace, avec Ctrl : zoome) · droite : zoome</translation>
    </message>
    <message>
        <source>Ctrl + middle: zoom</source>
        <translation>Ctrl + milieu : zoom</translation>
    </message>
    <message>
        <source>Shift + middle: move the view</source>
        <translation>Maj + milieu : déplacer la vue</translation>
    </message>
    <message>
        <source>Alt + drag: turn the view</source>
        <translation>Alt + glisser : tourner la vue</translation>
    </message>
    <message>
        <source>middle or Alt: turn the view</source>
        <translation>milieu ou Alt : tourner la vue</translation>
    </message>
</context>
<context>
    <name>ramure::NumberEditor</name>
    <message>
        <source>%1 slider</source>
        <translation>%1, curseur</translation>
    </message>
    <message>
        <source>Another random seed</source>
        <translation>Une autre graine au hasard</translation>
    </message>
</context>
<context>
    <name>ramure::NumberField</name>
    <message>
        <source>the largest is %1</source>
        <translation>le plus grand est %1</translation>
    </message>
    <message>
        <source>the smallest is %1</source>
        <translation>le plus petit est %1</translation>
    </message>
</context>
<context>
    <name>ramure::NumberSlider</name>
    <message>
        <source>Drag with Shift: ten times as fine</source>
        <translation>Glisser avec Maj : dix fois plus fin</translation>
    </message>
</context>
<context>
    <name>ramure::OutlineKey</name>
    <message>
        <source>selected</source>
        <translation>sélectionné</translation>
    </message>
    <message>
        <source>selected · %1: on or off</source>
        <translation>sélectionné · %1 : montrer ou non</translation>
    </message>
</context>
<context>
    <name>ramure::Palette</name>
    <message>
        <source>Commands, parameters and the handbook</source>
        <translation>Commandes, paramètres et manuel</translation>
    </message>
    <message>
        <source>Find a command, a parameter or a page of the handbook</source>
        <translation>Chercher une commande, un paramètre ou une page du manuel</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Nothing is called like this.</source>
        <translation>Rien ne porte ce nom.</translation>
    </message>
    <message>
        <source>Up and Down choose, Return runs or shows it, Esc closes</source>
        <translation>Haut et Bas choisissent, Entrée exécute ou montre, Échap ferme</translation>
    </message>
</context>
<context>
    <name>ramure::ParamRow</name>
    <message>
        <source>Key</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Revenir à la valeur par défaut</translation>
    </message>
    <message>
        <source>Back to the value of %1</source>
        <translation>Revenir à la valeur de %1</translation>
    </message>
    <message>
        <source>Take the picture away</source>
        <translation>Retirer l’image</translation>
    </message>
    <message>
        <source>It has no effect now: another value turns it off.</source>
        <translation>Sans effet maintenant : une autre valeur le désactive.</translation>
    </message>
    <message>
        <source>It has no effect while “%1” is off.</source>
        <translation>Sans effet tant que « %1 » est désactivé.</translation>
    </message>
</context>
<context>
    <name>ramure::PartsForm</name>
    <message>
        <source>Branches</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Fruit</source>
        <translation>Fruit</translation>
    </message>
    <message>
        <source>%1 has no objects: leaves and fruit would be mixed into the one closed mesh of the branches. Tick them to write them all the same.</source>
        <translation>%1 n’a pas d’objets : feuilles et fruits seraient mêlés à l’unique maillage fermé des branches. Cochez-les pour les écrire quand même.</translation>
    </message>
</context>
<context>
    <name>ramure::PhysicsPlot</name>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Length error</source>
        <translation>Erreur de longueur</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Physique</translation>
    </message>
    <message>
        <source>Figures of all trees over the latest frames: kinetic energy, the largest relative error of a branch&apos;s length, and the time of one physics step (ms)</source>
        <translation>Pour tous les arbres, sur les dernières images : énergie cinétique, plus grande erreur relative de longueur d’une branche, et durée d’un pas de la physique (ms)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Résidu</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Energy, length error and time of a step are drawn while it plays.</source>
        <translation>L&apos;énergie, l&apos;erreur de longueur et le temps d&apos;un pas se tracent pendant la lecture.</translation>
    </message>
    <message>
        <source>No arm follows a target: Ctrl+click sets one.</source>
        <translation>Aucun bras ne suit de cible : Ctrl+clic en pose une.</translation>
    </message>
    <message>
        <source>The largest distance from an arm&apos;s tip to its target (m), now and over the last ten seconds of its way; there is a curve once an arm has moved: played, or sent to a target by Ctrl+click on a surface</source>
        <translation>La plus grande distance entre le bout d&apos;un bras et sa cible (m), maintenant et sur les dix dernières secondes de son trajet ; une courbe apparaît dès qu&apos;un bras a bougé : pendant la lecture, ou envoyé vers une cible par Ctrl+clic sur une surface</translation>
    </message>
    <message>
        <source>Play, or Ctrl+click a surface, to see a curve.</source>
        <translation>Lecture ou Ctrl+clic sur une surface : la courbe se trace.</translation>
    </message>
    <message>
        <source>Copy the values as CSV</source>
        <translation>Copier les valeurs au format CSV</translation>
    </message>
    <message>
        <source>Copy the values for a spreadsheet</source>
        <translation>Copier les valeurs pour un tableur</translation>
    </message>
    <message>
        <source>Copies the columns, separated by tabs</source>
        <translation>Copie les colonnes, séparées par des tabulations</translation>
    </message>
    <message>
        <source>Start anew</source>
        <translation>Recommencer</translation>
    </message>
</context>
<context>
    <name>ramure::PictureActions</name>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>L’image est dans le presse-papiers</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Enregistrer une image</translation>
    </message>
    <message>
        <source>tree</source>
        <translation>arbre</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg);;All files (*)</source>
        <translation>Images (*.png *.jpg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Picture written to %1</source>
        <translation>Image écrite dans %1</translation>
    </message>
    <message>
        <source>No picture was written</source>
        <translation>Aucune image n’a été enregistrée</translation>
    </message>
    <message>
        <source>Click what is to be sharp · Esc: back to the picture</source>
        <translation>Cliquez sur ce qui doit être net · Échap : retour à l’image</translation>
    </message>
    <message>
        <source>Nothing is there: the focus stays as it was</source>
        <translation>Rien ne s’y trouve : la mise au point reste comme elle était</translation>
    </message>
</context>
<context>
    <name>ramure::PictureButton</name>
    <message>
        <source>Take it out of the favourites</source>
        <translation>Le retirer des favoris</translation>
    </message>
    <message>
        <source>Add it to the favourites</source>
        <translation>L’ajouter aux favoris</translation>
    </message>
</context>
<context>
    <name>ramure::PictureDialog</name>
    <message>
        <source>Save a picture</source>
        <translation>Enregistrer une image</translation>
    </message>
    <message>
        <source>Grid and axes</source>
        <translation>Grille et axes</translation>
    </message>
    <message>
        <source>The lines on the ground</source>
        <translation>Les lignes au sol</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ramure::PictureEditor</name>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Images (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Choose a picture, or drop one here</source>
        <translation>Choisir une image, ou en déposer une ici</translation>
    </message>
    <message>
        <source>%1: choose</source>
        <translation>%1 : choisir</translation>
    </message>
</context>
<context>
    <name>ramure::PictureForm</name>
    <message>
        <source>Width of the pictures in pixels, 16 to 8192</source>
        <translation>Largeur des images en pixels, de 16 à 8192</translation>
    </message>
    <message>
        <source>Height of the pictures in pixels, 16 to 8192</source>
        <translation>Hauteur des images en pixels, de 16 à 8192</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Taille libre</translation>
    </message>
    <message>
        <source>Common sizes</source>
        <translation>Tailles courantes</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fond transparent</translation>
    </message>
    <message>
        <source>Leaves out sky and ground, to put the trees in front of another picture</source>
        <translation>Omet le ciel et le sol, pour placer les arbres devant une autre image</translation>
    </message>
    <message>
        <source>As the view, %1 × %2</source>
        <translation>Comme la vue, %1 × %2</translation>
    </message>
    <message>
        <source>Keep the view&apos;s ratio</source>
        <translation>Garder le rapport de la vue</translation>
    </message>
    <message>
        <source>Keeps the ratio of the view, so that the picture shows the same part of the scene. If off, it shows more or less at its sides</source>
        <translation>Garde les proportions de la vue, pour que l’image montre la même partie de la scène. Sinon, elle en montre plus ou moins sur ses bords</translation>
    </message>
</context>
<context>
    <name>ramure::PlaceTool</name>
    <message>
        <source>Release: it grows here, on the side that was clicked · Esc: not at all</source>
        <translation>Relâcher : elle pousse ici, du côté du clic · Échap : pas du tout</translation>
    </message>
    <message>
        <source>Click a branch: a leaf grows there</source>
        <translation>Clic sur une branche : une feuille y pousse</translation>
    </message>
    <message>
        <source>Click a branch: a fruit hangs there</source>
        <translation>Clic sur une branche : un fruit y pend</translation>
    </message>
    <message>
        <source>Click a branch: a flower opens there</source>
        <translation>Clic sur une branche : une fleur s’y ouvre</translation>
    </message>
    <message>
        <source>This tree bears fruit: one was put there. “Fruit” in its parameters makes flowers of all.</source>
        <translation>Cet arbre porte des fruits : il y en a un de plus. « Fruits », dans ses paramètres, en fait des fleurs.</translation>
    </message>
    <message>
        <source>This tree blooms: a flower was put there. “Fruit” in its parameters makes fruit of all.</source>
        <translation>Cet arbre est en fleurs : il y en a une de plus. « Fruits », dans ses paramètres, en fait des fruits.</translation>
    </message>
</context>
<context>
    <name>ramure::Planting</name>
    <message>
        <source>Move beside the others</source>
        <translation>Poser à côté des autres</translation>
    </message>
</context>
<context>
    <name>ramure::PlayActions</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
</context>
<context>
    <name>ramure::PreferencesDialog</name>
    <message>
        <source>Alt with the left button orbits, with the middle one pans, with the right one zooms.</source>
        <translation>Alt avec le bouton gauche tourne autour, avec celui du milieu déplace, avec le droit zoome.</translation>
    </message>
    <message>
        <source>The middle button orbits, with Shift it pans, with Ctrl it zooms.</source>
        <translation>Le bouton du milieu tourne autour, avec Maj il déplace, avec Ctrl il zoome.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Thème&#xa0;:</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Langue&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Angles in:</source>
        <translation>&amp;Angles en&#xa0;:</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Degrés</translation>
    </message>
    <message>
        <source>Radians</source>
        <translation>Radians</translation>
    </message>
    <message>
        <source>&amp;Navigation:</source>
        <translation>&amp;Navigation&#xa0;:</translation>
    </message>
    <message>
        <source>Like Blender</source>
        <translation>Comme Blender</translation>
    </message>
    <message>
        <source>Like Maya</source>
        <translation>Comme Maya</translation>
    </message>
    <message>
        <source>A&amp;utosave every:</source>
        <translation>Sa&amp;uvegarde toutes les&#xa0;:</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Jamais</translation>
    </message>
    <message>
        <source>Unsaved changes are kept aside, so that a crash costs no more than that. Your own file is written only when you save it.</source>
        <translation>Les modifications non enregistrées sont gardées à part, pour qu’un plantage ne coûte pas davantage. Votre fichier n’est écrit que lorsque vous l’enregistrez.</translation>
    </message>
    <message>
        <source>Show the &amp;welcome page at the start</source>
        <translation>Afficher la page d’&amp;accueil au démarrage</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Valeurs d’origine</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>T&amp;imes in:</source>
        <translation>&amp;Instants en :</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Timecode</source>
        <translation>Timecode</translation>
    </message>
    <message>
        <source>&amp;Memory for motion:</source>
        <translation>&amp;Mémoire du mouvement :</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>Megabytes for computed frames, of all trees together: %L1 to %L2</source>
        <translation>Mégaoctets pour les images calculées, tous les arbres ensemble : %L1 à %L2</translation>
    </message>
    <message>
        <source>With less memory, fewer moments of a long run are kept, and a jump within it computes a few more steps.</source>
        <translation>Avec moins de mémoire, on garde moins d’instants d’un long calcul, et un saut recalcule quelques pas de plus.</translation>
    </message>
    <message>
        <source>The language changes when Ramure is started again.</source>
        <translation>La langue change au prochain démarrage de Ramure.</translation>
    </message>
</context>
<context>
    <name>ramure::PresetGallery</name>
    <message>
        <source>No tree is called “%1”. Search for a name, a Latin name or a word of its description.</source>
        <translation>Aucun arbre ne s’appelle «&#xa0;%1&#xa0;». Cherchez un nom, un nom latin ou un mot de sa description.</translation>
    </message>
    <message>
        <source>Search trees</source>
        <translation>Chercher des arbres</translation>
    </message>
    <message>
        <source>%1: a tree that you have kept</source>
        <translation>%1 : un arbre que vous avez gardé</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favori</translation>
    </message>
</context>
<context>
    <name>ramure::PrintForm</name>
    <message>
        <source>Make ready for a printer</source>
        <translation>Préparer pour une imprimante 3D</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Préparer</translation>
    </message>
    <message>
        <source>One tree as one closed surface that is thick enough and flat at the ground, in millimetres with Z up</source>
        <translation>Un arbre en une seule surface fermée, assez épaisse et plate au sol, en millimètres avec Z vers le haut</translation>
    </message>
    <message>
        <source>Makes the print, shows it and says how thin it is and whether it stands; writes nothing</source>
        <translation>Fait l’impression, la montre et dit quelle est sa plus petite épaisseur et si elle tient debout ; n’écrit rien</translation>
    </message>
    <message>
        <source>Preparing the print</source>
        <translation>Préparation de l’impression</translation>
    </message>
    <message>
        <source>Give this up</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ramure::PrintPreview</name>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message numerus="yes">
        <source>%n closed</source>
        <comment>pieces</comment>
        <translation>
            <numerusform>%n fermé</numerusform>
            <numerusform>%n fermés</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 thickened, %2 cut</source>
        <translation>%1 épaissies, %2 coupées</translation>
    </message>
    <message>
        <source>%1 shells, %2 left out</source>
        <translation>%1 coques, %2 laissées de côté</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Thinnest place</source>
        <translation>Endroit le plus fin</translation>
    </message>
    <message>
        <source>Overhangs</source>
        <translation>Surplombs</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Tient debout</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Area that overhangs by more than 45°, in cm²: it needs supports</source>
        <translation>Surface en surplomb de plus de 45°, en cm² : il lui faut des supports</translation>
    </message>
    <message>
        <source>Whether its centre of mass is over the foot, and how far from the foot’s border, in mm</source>
        <translation>Si son centre de gravité est au-dessus du pied, et à quelle distance du bord du pied, en mm</translation>
    </message>
    <message>
        <source>The picture flies there</source>
        <translation>L’image y vole</translation>
    </message>
    <message>
        <source>Whole print</source>
        <translation>Toute l’impression</translation>
    </message>
    <message>
        <source>All of it comes into the picture</source>
        <translation>Elle entre tout entière dans l’image</translation>
    </message>
    <message>
        <source>Overhangs steeper than 45°</source>
        <translation>Surplombs de plus de 45°</translation>
    </message>
    <message>
        <source>%1 mm of %2</source>
        <translation>%1 mm sur %2</translation>
    </message>
    <message>
        <source>At (%1, %2, %3) mm</source>
        <translation>En (%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>no: not on the ground</source>
        <translation>non : pas au sol</translation>
    </message>
    <message>
        <source>yes, by %1 mm</source>
        <translation>oui, de %1 mm</translation>
    </message>
    <message>
        <source>no, by %1 mm</source>
        <translation>non, de %1 mm</translation>
    </message>
</context>
<context>
    <name>ramure::PrintView</name>
    <message>
        <source>Drawing…</source>
        <translation>Dessin…</translation>
    </message>
    <message>
        <source>Picture of the print</source>
        <translation>Image de l’impression</translation>
    </message>
    <message>
        <source>Drag or arrow keys: turn · Shift or the right button: move · wheel, + and −: nearer or farther · Home or a double click: all of it</source>
        <translation>Glisser ou flèches : tourner · Maj ou le bouton droit : déplacer · molette, + et − : plus près ou plus loin · Origine ou double clic : tout voir</translation>
    </message>
</context>
<context>
    <name>ramure::ProfileCurve</name>
    <message>
        <source>Round</source>
        <translation>Rond</translation>
    </message>
    <message>
        <source>Egg</source>
        <translation>Œuf</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>Vase</translation>
    </message>
    <message>
        <source>Umbrella</source>
        <translation>Parasol</translation>
    </message>
    <message>
        <source>In tiers</source>
        <translation>Étagé</translation>
    </message>
    <message>
        <source>Add a point here</source>
        <translation>Ajouter un point ici</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Retirer le point</translation>
    </message>
</context>
<context>
    <name>ramure::ProfileEditor</name>
    <message>
        <source>Drag the points; double-click to add one, right-click for more. Height goes up, half the width to the right.</source>
        <translation>Glissez les points ; un double-clic en ajoute un, un clic droit offre le reste. La hauteur va vers le haut, la demi-largeur vers la droite.</translation>
    </message>
    <message>
        <source>%1 as text</source>
        <translation>%1 en texte</translation>
    </message>
</context>
<context>
    <name>ramure::PropertiesPanel</name>
    <message>
        <source>Select a tree in the scene or in the view to change it.</source>
        <translation>Sélectionnez un arbre dans la scène ou dans la vue pour le modifier.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Coller %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Réinitialiser %1</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Chercher un paramètre</translation>
    </message>
    <message>
        <source>Nothing selected</source>
        <translation>Rien de sélectionné</translation>
    </message>
    <message>
        <source>%1 (locked)</source>
        <translation>%1 (verrouillé)</translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) selected</source>
        <translation>
            <numerusform>%n nœud sélectionné</numerusform>
            <numerusform>%n nœuds sélectionnés</numerusform>
        </translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Copier la valeur</translation>
    </message>
    <message>
        <source>Paste value</source>
        <translation>Coller la valeur</translation>
    </message>
    <message>
        <source>Copy as --set for the command line</source>
        <translation>Copier comme --set pour la ligne de commande</translation>
    </message>
    <message>
        <source>Take the key away</source>
        <translation>Retirer la clé</translation>
    </message>
    <message>
        <source>Insert a key</source>
        <translation>Insérer une clé</translation>
    </message>
    <message>
        <source>No parameter of the selection is called “%1”.</source>
        <translation>Aucun paramètre de la sélection ne s’appelle « %1 ».</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>Effacer la recherche</translation>
    </message>
</context>
<context>
    <name>ramure::PruneTool</name>
    <message>
        <source>Drag from the middle of the tree outwards: it is cut to the shape</source>
        <translation>Glisser du milieu de l’arbre vers l’extérieur : il est taillé en forme</translation>
    </message>
    <message>
        <source>Press on the tree that is to be pruned, or select it first.</source>
        <translation>Appuyez sur l’arbre à tailler, ou sélectionnez-le d’abord.</translation>
    </message>
    <message>
        <source>Drag from the middle of the tree outwards.</source>
        <translation>Glissez du milieu de l’arbre vers l’extérieur.</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>rayon %1 m</translation>
    </message>
    <message>
        <source>radius %1 m, %2 m high</source>
        <translation>rayon %1 m, %2 m de haut</translation>
    </message>
    <message>
        <source>%1 m wide, %2 m high</source>
        <translation>%1 m de large, %2 m de haut</translation>
    </message>
    <message>
        <source>Click a solid around the tree: the wood outside it is cut</source>
        <translation>Cliquer sur un solide autour de l’arbre : le bois qui en dépasse est coupé</translation>
    </message>
    <message>
        <source>Draw half of the outline beside the trunk: the tree is cut to it</source>
        <translation>Dessiner la moitié du contour à côté du tronc : l’arbre y est taillé</translation>
    </message>
    <message>
        <source>Select the tree, then click the solid that it is to be pruned to.</source>
        <translation>Sélectionnez l’arbre, puis cliquez sur le solide qui doit le tailler.</translation>
    </message>
    <message>
        <source>Draw half of the outline beside the trunk.</source>
        <translation>Dessinez la moitié du contour à côté du tronc.</translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation>%1 m de haut</translation>
    </message>
    <message>
        <source>Red: %1 would go · release: cut · Esc: nothing is cut</source>
        <translation>En rouge : %1 partiraient · relâcher : couper · Échap : rien n’est coupé</translation>
    </message>
    <message>
        <source>Nothing is cut: %1 · Esc: back</source>
        <translation>Rien n’est coupé : %1 · Échap : retour</translation>
    </message>
    <message>
        <source>The stroke was too short: draw half of the outline beside the trunk.</source>
        <translation>Trait trop court : dessinez la moitié du contour à côté du tronc.</translation>
    </message>
    <message>
        <source>The stroke was too short: drag from the middle of the tree outwards, and the red parts go.</source>
        <translation>Trait trop court : glissez du milieu de l’arbre vers l’extérieur, et les parties rouges partent.</translation>
    </message>
    <message>
        <source>%1 would go</source>
        <translation>%1 partiraient</translation>
    </message>
</context>
<context>
    <name>ramure::PullTool</name>
    <message>
        <source>The branch is pulled · release: it swings back</source>
        <translation>La branche est tirée · relâcher : elle revient</translation>
    </message>
    <message>
        <source>Drag: pull the branch · double click an apple: it falls</source>
        <translation>Glisser : tirer la branche · double clic sur une pomme : elle tombe</translation>
    </message>
    <message>
        <source>Ctrl: drag pulls the branch</source>
        <translation>Ctrl : glisser tire la branche</translation>
    </message>
</context>
<context>
    <name>ramure::RecipeActions</name>
    <message>
        <source>Add a &amp;step</source>
        <translation>Ajouter une &amp;étape</translation>
    </message>
    <message>
        <source>Modifiers</source>
        <translation>Modificateurs</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Sources</translation>
    </message>
    <message>
        <source>Source &amp;like a preset</source>
        <translation>Source comme un &amp;modèle</translation>
    </message>
    <message>
        <source>&amp;My steps</source>
        <translation>&amp;Mes étapes</translation>
    </message>
    <message>
        <source>Kept as “%1”: Add a step &gt; My steps adds it to any tree</source>
        <translation>Gardé comme « %1 » : Ajouter une étape &gt; Mes étapes l’ajoute à n’importe quel arbre</translation>
    </message>
</context>
<context>
    <name>ramure::RecipeModel</name>
    <message>
        <source>%1 %</source>
        <comment>a share</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>an edit and its factor</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>an edit and its place</comment>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Leaves on</source>
        <translation>Feuilles remises</translation>
    </message>
    <message>
        <source>Leaves off</source>
        <translation>Feuilles ôtées</translation>
    </message>
    <message>
        <source>no place at present</source>
        <translation>sans place à présent</translation>
    </message>
    <message>
        <source>It is kept, and acts again as soon as there is such a limb: %1</source>
        <translation>Elle est gardée, et agit de nouveau dès qu’il y a une telle branche : %1</translation>
    </message>
    <message>
        <source>on the ground</source>
        <translation>au sol</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>It changes nothing now: %1</source>
        <translation>Cela ne change rien en ce moment : %1</translation>
    </message>
    <message>
        <source>The recipe&apos;s first source: its values are the tree&apos;s parameters</source>
        <translation>La première source de la recette : ses valeurs sont les paramètres de l’arbre</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message numerus="yes">
        <source>%n chosen axis(es)</source>
        <translation>
            <numerusform>%n axe choisi</numerusform>
            <numerusform>%n axes choisis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hand edit(s)</source>
        <translation>
            <numerusform>%n retouche à la main</numerusform>
            <numerusform>%n retouches à la main</numerusform>
        </translation>
    </message>
    <message>
        <source>Consecutive hand edits. A change of this row changes all of them.</source>
        <translation>Des retouches à la main qui se suivent. Un changement de cette ligne les change toutes.</translation>
    </message>
    <message>
        <source>It does not run, because a step below holds its result</source>
        <translation>Elle ne s’exécute pas, car une étape plus bas garde son résultat</translation>
    </message>
    <message>
        <source>The tree is younger: it acts from the year %1 on</source>
        <translation>L’arbre est plus jeune : elle agit à partir de %1 ans</translation>
    </message>
    <message>
        <source>the whole tree</source>
        <translation>tout l’arbre</translation>
    </message>
    <message>
        <source>in year %1</source>
        <comment>an edit of a growing tree</comment>
        <translation>à %1 ans</translation>
    </message>
</context>
<context>
    <name>ramure::RecipePanel</name>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Remettre</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy to</source>
        <translation>Copier vers</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Copy the selected steps to another tree</source>
        <translation>Copier les étapes sélectionnées vers un autre arbre</translation>
    </message>
    <message>
        <source>Delete the selected steps (Del)</source>
        <translation>Supprimer les étapes sélectionnées (Suppr)</translation>
    </message>
    <message>
        <source>Add a step to the recipe</source>
        <translation>Ajouter une étape à la recette</translation>
    </message>
    <message>
        <source>Steps of the recipe</source>
        <translation>Étapes de la recette</translation>
    </message>
    <message>
        <source>Select a tree: its recipe is listed here, the steps that make it one after the other.</source>
        <translation>Sélectionnez un arbre : sa recette s’affiche ici, les étapes qui le font l’une après l’autre.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Keep as a preset of steps</source>
        <translation>Garder comme modèle d’étapes</translation>
    </message>
    <message>
        <source>Freeze up to here</source>
        <translation>Geler jusqu’ici</translation>
    </message>
    <message>
        <source>Act on the selected branches only</source>
        <translation>N’agir que sur les branches sélectionnées</translation>
    </message>
    <message>
        <source>Thaw: the steps above run again</source>
        <translation>Dégeler : les étapes du dessus s’exécutent de nouveau</translation>
    </message>
    <message>
        <source>The tree answers in later years</source>
        <translation>L’arbre répond les années suivantes</translation>
    </message>
    <message>
        <source>Cut the tree as it has grown</source>
        <translation>Couper l’arbre tel qu’il a poussé</translation>
    </message>
    <message>
        <source>Let the tree answer a cut</source>
        <translation>Laisser l’arbre répondre à une coupe</translation>
    </message>
    <message>
        <source>Move up (Alt+Up): the step acts before the one above</source>
        <translation>Monter (Alt+Haut)&#xa0;: l’étape agit avant celle du dessus</translation>
    </message>
    <message>
        <source>Move down (Alt+Down): the step acts after the one below</source>
        <translation>Descendre (Alt+Bas)&#xa0;: l’étape agit après celle du dessous</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
</context>
<context>
    <name>ramure::Recovery</name>
    <message>
        <source>Unsaved changes cannot be kept aside, so a crash would lose them. Please save often.</source>
        <translation>Les modifications non enregistrées ne peuvent pas être gardées à part&#xa0;: un plantage les perdrait. Enregistrez souvent.</translation>
    </message>
    <message>
        <source>The unsaved work could not be read.</source>
        <translation>Le travail non enregistré n’a pas pu être lu.</translation>
    </message>
    <message>
        <source>Unsaved changes are kept aside again.</source>
        <translation>Les modifications non enregistrées sont de nouveau gardées à part.</translation>
    </message>
</context>
<context>
    <name>ramure::RecoveryDialog</name>
    <message>
        <source>Recover unsaved work</source>
        <translation>Récupérer le travail non enregistré</translation>
    </message>
    <message>
        <source>Ramure did not end in good order last time. These changes had not been saved:</source>
        <translation>Ramure ne s’est pas terminé normalement la dernière fois. Ces modifications n’avaient pas été enregistrées&#xa0;:</translation>
    </message>
    <message>
        <source>“Recover” opens the selected one; nothing is written to its file until you save. “Later” asks again at the next start.</source>
        <translation>«&#xa0;Récupérer&#xa0;» ouvre l’élément sélectionné&#xa0;; rien n’est écrit dans son fichier avant que vous n’enregistriez. «&#xa0;Plus tard&#xa0;» repose la question au prochain démarrage.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Last change kept</source>
        <translation>Dernier état gardé</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>jamais enregistré</translation>
    </message>
    <message>
        <source>File saved later</source>
        <translation>Fichier enregistré ensuite</translation>
    </message>
    <message>
        <source>The file was saved after this change was kept. “Recover” may open an older state than the file; compare the two before you save.</source>
        <translation>Le fichier a été enregistré après que cette modification a été gardée. « Récupérer » ouvre peut-être un état plus ancien que le fichier ; comparez les deux avant d’enregistrer.</translation>
    </message>
</context>
<context>
    <name>ramure::RemoveTool</name>
    <message>
        <source>Click: the limb goes · one of several selected: all of them</source>
        <translation>Clic : la branche s’en va · une de plusieurs sélectionnées : toutes</translation>
    </message>
    <message>
        <source>Click: the limb goes, %1</source>
        <translation>Clic : la branche part, %1</translation>
    </message>
    <message>
        <source>Release: %1 go · Esc: all stays</source>
        <translation>Relâcher : %1 partent · Échap : tout reste</translation>
    </message>
    <message>
        <source>Release: all stays</source>
        <translation>Relâcher : tout reste</translation>
    </message>
</context>
<context>
    <name>ramure::ReportModel</name>
    <message>
        <source>Edge %1–%2</source>
        <translation>Arête %1–%2</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Sommet %1</translation>
    </message>
    <message>
        <source>Vertices %1 and %2</source>
        <translation>Sommets %1 et %2</translation>
    </message>
    <message>
        <source>Faces %1 and %2</source>
        <translation>Faces %1 et %2</translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation>Face %1</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Branche %1</translation>
    </message>
    <message>
        <source>Branch %1, now with %2</source>
        <translation>Branche %1, désormais avec %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2, the first %3 listed</source>
        <translation>%1&#xa0;: %2, les %3 premiers listés</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Branche</translation>
    </message>
    <message>
        <source>Place (m)</source>
        <translation>Place (m)</translation>
    </message>
    <message>
        <source>%3 deep: branches %1 and %2</source>
        <translation>%3 de profondeur : branches %1 et %2</translation>
    </message>
    <message>
        <source>Face %1, %2</source>
        <translation>Face %1, %2</translation>
    </message>
</context>
<context>
    <name>ramure::RestTool</name>
    <message>
        <source>Trees are shaped at rest: the timeline is at frame %1 now. Press again.</source>
        <translation>On façonne les arbres au repos : la ligne de temps est maintenant à l’image %1. Cliquez encore.</translation>
    </message>
    <message>
        <source>Click: to frame %1, where the tree is at rest and can be shaped</source>
        <translation>Clic : vers l’image %1, où l’arbre est au repos et peut être façonné</translation>
    </message>
</context>
<context>
    <name>ramure::RollEditor</name>
    <message>
        <source>Roll by hand</source>
        <translation>Roulis à la main</translation>
    </message>
    <message>
        <source>Turns the branch&apos;s frames about its curve. The branches it carries turn along, and the mesh follows.</source>
        <translation>Tourne les repères de la branche autour de sa courbe. Les branches qu’elle porte tournent avec elle, et le maillage suit.</translation>
    </message>
    <message>
        <source>Roll by hand, slider</source>
        <translation>Roulis à la main, curseur</translation>
    </message>
    <message>
        <source>Back to no roll</source>
        <translation>Revenir sans roulis</translation>
    </message>
    <message>
        <source>The tree is locked.</source>
        <translation>L’arbre est verrouillé.</translation>
    </message>
    <message numerus="yes">
        <source>For all %n selected branch(es).</source>
        <translation>
            <numerusform>Pour la branche sélectionnée.</numerusform>
            <numerusform>Pour les %n branches sélectionnées.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::RootTool</name>
    <message>
        <source>Digits: flare · wheel: more or less · Enter or click: done · Esc: back</source>
        <translation>Chiffres : évasement · molette : plus ou moins · Entrée ou clic : fait · Échap : retour</translation>
    </message>
    <message>
        <source>Release: done · Ctrl, wheel or digits: flare of the foot · Esc: back</source>
        <translation>Lâcher : fait · Ctrl, molette ou chiffres : évasement du pied · Échap : retour</translation>
    </message>
    <message>
        <source>Drag the tree: its foot goes over the ground</source>
        <translation>Glisser l’arbre : son pied va sur le sol</translation>
    </message>
    <message>
        <source>Click: type how wide its foot is</source>
        <translation>Clic : taper la largeur de son pied</translation>
    </message>
    <message>
        <source>%1 m · foot × %2</source>
        <translation>%1 m · pied × %2</translation>
    </message>
    <message>
        <source>foot × %1</source>
        <translation>pied × %1</translation>
    </message>
    <message>
        <source> · type a number</source>
        <translation> · tapez un nombre</translation>
    </message>
</context>
<context>
    <name>ramure::RulerMenu</name>
    <message>
        <source>&amp;Go to frame %1</source>
        <translation>&amp;Aller à l’image %1</translation>
    </message>
    <message>
        <source>Insert &amp;keys at frame %1</source>
        <translation>Insérer des &amp;clés à l’image %1</translation>
    </message>
    <message>
        <source>&amp;First frame of the range: %1</source>
        <translation>&amp;Première image de la plage&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Last frame of the range: %1</source>
        <translation>&amp;Dernière image de la plage&#xa0;: %1</translation>
    </message>
    <message>
        <source>Show the &amp;whole range</source>
        <translation>Montrer &amp;toute la plage</translation>
    </message>
    <message>
        <source>At the &amp;end</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>Show &amp;moments as</source>
        <translation>Montrer les &amp;moments en</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Timecode</source>
        <translation>Timecode</translation>
    </message>
</context>
<context>
    <name>ramure::SawTool</name>
    <message>
        <source>The line cuts all branches it crosses · release: done · Esc: nothing is cut</source>
        <translation>La ligne coupe toutes les branches qu’elle croise · lâcher : fait · Échap : rien n’est coupé</translation>
    </message>
    <message>
        <source>Drag a line through twigs: they are cut there</source>
        <translation>Tirer une ligne à travers des rameaux : ils y sont coupés</translation>
    </message>
    <message numerus="yes">
        <source>%n cut(s)</source>
        <translation>
            <numerusform>%n coupe</numerusform>
            <numerusform>%n coupes</numerusform>
        </translation>
    </message>
    <message>
        <source>Branches inside are cut · release: done · Esc: nothing is cut</source>
        <translation>Les branches à l’intérieur sont coupées · lâcher : fait · Échap : rien n’est coupé</translation>
    </message>
    <message>
        <source>Drag around twigs: the twigs inside are cut</source>
        <translation>Entourez des rameaux : ceux qui sont à l’intérieur sont coupés</translation>
    </message>
</context>
<context>
    <name>ramure::SceneModel</name>
    <message>
        <source>Hidden</source>
        <translation>Masqué</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Hidden by its parent</source>
        <translation>Masqué par son parent</translation>
    </message>
    <message>
        <source>Locked: cannot be changed</source>
        <translation>Verrouillé&#xa0;: ne peut être modifié</translation>
    </message>
    <message>
        <source>Not locked</source>
        <translation>Non verrouillé</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Enfants</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Length in metres</source>
        <translation>Longueur en mètres</translation>
    </message>
    <message>
        <source>Radius at the lower end, in metres</source>
        <translation>Rayon à l’extrémité basse, en mètres</translation>
    </message>
    <message>
        <source>Depth of brackets: 0 is the trunk</source>
        <translation>Profondeur des crochets&#xa0;: 0 est le tronc</translation>
    </message>
    <message>
        <source>Move nodes</source>
        <translation>Déplacer des nœuds</translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es) in all</source>
        <translation>
            <numerusform>%Ln branche en tout</numerusform>
            <numerusform>%Ln branches en tout</numerusform>
        </translation>
    </message>
    <message>
        <source>Branch %1 in reports and files</source>
        <translation>Branche %1 dans les rapports et les fichiers</translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branche</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message>
        <source>The branches of %1 one by one, from foot to tip</source>
        <translation>%1&#xa0;: ses tronçons un par un, du pied à la pointe</translation>
    </message>
    <message>
        <source>Rows below it; of a single branch that was searched for: the branches that begin at its end</source>
        <translation>Lignes en dessous&#xa0;; pour une seule branche trouvée par une recherche&#xa0;: les branches qui partent de son extrémité</translation>
    </message>
    <message>
        <source>Length (m)</source>
        <translation>Longueur (m)</translation>
    </message>
    <message>
        <source>Radius (m)</source>
        <translation>Rayon (m)</translation>
    </message>
</context>
<context>
    <name>ramure::ScenePanel</name>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Branches of one tree are selected at a time: now those of %1.</source>
        <translation>On sélectionne les branches d’un seul arbre à la fois : à présent celles de %1.</translation>
    </message>
    <message>
        <source>Frame in the view</source>
        <translation>Cadrer dans la vue</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Unfold all below</source>
        <translation>Déplier tout ce qui est dessous</translation>
    </message>
    <message>
        <source>Fold everything</source>
        <translation>Tout replier</translation>
    </message>
    <message>
        <source>Found in the scene</source>
        <translation>Trouvé dans la scène</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Drop: the node stays where it is in the world (with Shift: keeps its values)</source>
        <translation>Déposer : le nœud reste où il est dans le monde (avec Maj : il garde ses valeurs)</translation>
    </message>
    <message>
        <source>Drop: the node keeps its position, rotation and scale in the new parent</source>
        <translation>Déposer : le nœud garde sa position, sa rotation et son échelle dans le nouveau parent</translation>
    </message>
</context>
<context>
    <name>ramure::SceneSearch</name>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n nœud</numerusform>
            <numerusform>%n nœuds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branche</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Aucun résultat</translation>
    </message>
    <message>
        <source>Search: name, %1 &gt; %2, %3</source>
        <translation>Chercher : nom, %1 &gt; %2, %3</translation>
    </message>
    <message>
        <source>Search the scene</source>
        <translation>Chercher dans la scène</translation>
    </message>
    <message>
        <source>oak</source>
        <translation>chêne</translation>
    </message>
    <message>
        <source>thinner at the lower end; mm, cm, m, in, ft</source>
        <translation>plus minces à la base ; mm, cm, m, in, ft</translation>
    </message>
    <message>
        <source>of this depth of brackets; 0 is the trunk</source>
        <translation>à cette profondeur de crochets ; 0 est le tronc</translation>
    </message>
    <message>
        <source>with so many branches at the end</source>
        <translation>avec autant de branches à l’extrémité</translation>
    </message>
    <message>
        <source>with none at the end</source>
        <translation>sans branche à l’extrémité</translation>
    </message>
    <message>
        <source>Several must all hold: %1. Enter selects everything found.</source>
        <translation>Plusieurs conditions doivent toutes être vraies : %1. Entrée sélectionne tout ce qui est trouvé.</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Select everything found (Enter in the field)</source>
        <translation>Sélectionner tout ce qui est trouvé (Entrée dans le champ)</translation>
    </message>
    <message numerus="yes">
        <source>%Ln limb(s) or twig(s)</source>
        <translation>
            <numerusform>%Ln branche ou rameau</numerusform>
            <numerusform>%Ln branches et rameaux</numerusform>
        </translation>
    </message>
    <message>
        <source>nodes whose name has this</source>
        <translation>les nœuds dont le nom contient ceci</translation>
    </message>
    <message>
        <source>limb 3</source>
        <translation>maîtresse 3</translation>
    </message>
    <message>
        <source>limbs, boughs and twigs of that name</source>
        <translation>les branches et les rameaux de ce nom</translation>
    </message>
    <message>
        <source>the branch of that number in reports and files</source>
        <translation>la branche de ce numéro dans les rapports et les fichiers</translation>
    </message>
    <message>
        <source>of limbs longer than that, in metres</source>
        <translation>de branches maîtresses plus longues, en mètres</translation>
    </message>
</context>
<context>
    <name>ramure::SectionBrowser</name>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s) copied as CSV</source>
        <translation>
            <numerusform>%n section copiée en CSV</numerusform>
            <numerusform>%n sections copiées en CSV</numerusform>
        </translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Section, slider</source>
        <translation>Section, curseur</translation>
    </message>
    <message>
        <source>Steps through the sections. The viewport shows the section&apos;s plane and frame.</source>
        <translation>Parcourt les sections. La vue montre le plan et le repère de la section.</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Copier en CSV</translation>
    </message>
    <message>
        <source>Copies all sections as comma-separated values for a spreadsheet. Ctrl+C in the table does the same, or copies the selected rows where there are several.</source>
        <translation>Copie toutes les sections en valeurs séparées par des virgules, pour un tableur. Ctrl+C dans le tableau fait de même, ou copie les lignes sélectionnées s’il y en a plusieurs.</translation>
    </message>
    <message>
        <source>All sections</source>
        <translation>Toutes les sections</translation>
    </message>
</context>
<context>
    <name>ramure::SectionModel</name>
    <message>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Paramètre t</translation>
    </message>
    <message>
        <source>Arc length</source>
        <translation>Abscisse curviligne</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Binormal</source>
        <translation>Binormale</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>Twist per metre</source>
        <translation>Torsion par mètre</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>Counted from 1 at the branch&apos;s start.</source>
        <translation>Comptée à partir de 1 au début de la branche.</translation>
    </message>
    <message>
        <source>Position of the section on the branch&apos;s curve: 0 at its start, 1 at its end.</source>
        <translation>Position de la section sur la courbe de la branche : 0 au début, 1 à la fin.</translation>
    </message>
    <message>
        <source>Way along the curve from the branch&apos;s start.</source>
        <translation>Chemin le long de la courbe depuis le début de la branche.</translation>
    </message>
    <message>
        <source>In the tree&apos;s space, Y up.</source>
        <translation>Dans l’espace de l’arbre, Y vers le haut.</translation>
    </message>
    <message>
        <source>Direction of the curve; the section is perpendicular to it.</source>
        <translation>Direction de la courbe ; la section lui est perpendiculaire.</translation>
    </message>
    <message>
        <source>Points from the centre to the first point of the section&apos;s circle.</source>
        <translation>Pointe du centre vers le premier point du cercle de la section.</translation>
    </message>
    <message>
        <source>Tangent × normal: a quarter turn on from the normal.</source>
        <translation>Tangente × normale&#xa0;: un quart de tour après la normale.</translation>
    </message>
    <message>
        <source>Radius of the section&apos;s circle.</source>
        <translation>Rayon du cercle de la section.</translation>
    </message>
    <message>
        <source>One over the radius of the circle that fits the curve here; 0 if the curve is straight.</source>
        <translation>L’inverse du rayon du cercle qui épouse la courbe ici ; 0 si la courbe est droite.</translation>
    </message>
    <message>
        <source>How fast the frame turns about the curve, compared with a rotation-minimising frame, for which it is 0.</source>
        <translation>À quelle vitesse le repère tourne autour de la courbe, comparé à un repère à rotation minimale, pour lequel elle vaut 0.</translation>
    </message>
    <message>
        <source>How far the frame is turned about the curve since the parent&apos;s end: the roll by hand and the twist up to here.</source>
        <translation>De combien le repère a tourné autour de la courbe depuis le bout du parent&#xa0;: le roulis à la main et la torsion jusqu’ici.</translation>
    </message>
</context>
<context>
    <name>ramure::SeedsDialog</name>
    <message>
        <source>More like %1</source>
        <translation>D’autres comme %1</translation>
    </message>
    <message>
        <source>Nine &amp;others</source>
        <translation>Neuf &amp;autres</translation>
    </message>
    <message>
        <source>Click a tree to add it to the scene.</source>
        <translation>Cliquez sur un arbre pour l’ajouter à la scène.</translation>
    </message>
    <message>
        <source>Click a tree: the one in the scene grows like it.</source>
        <translation>Cliquez sur un arbre : celui de la scène pousse comme lui.</translation>
    </message>
    <message>
        <source>Nothing but the places of its leaves varies: no rule has chances, and the variation of angles, lengths and radii is 0 %.</source>
        <translation>Seules les places de ses feuilles varient : aucune règle n’a de hasard, et la variation des angles, des longueurs et des rayons est de 0 %.</translation>
    </message>
    <message>
        <source>Growing %1 of %2 …</source>
        <translation>Pousse : %1 sur %2…</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Graine %1</translation>
    </message>
    <message>
        <source>Seed %1: %2</source>
        <comment>2: tall, wide …</comment>
        <translation>Graine %1 : %2</translation>
    </message>
    <message>
        <source>At three &amp;ages</source>
        <translation>À trois â&amp;ges</translation>
    </message>
    <message>
        <source>Three seeds, each young, mature and old</source>
        <translation>Trois graines, chacune jeune, adulte et vieille</translation>
    </message>
    <message>
        <source>Give the tree seed %1</source>
        <translation>Donner à l’arbre la graine %1</translation>
    </message>
    <message numerus="yes">
        <source>Seed %1, %n year(s)</source>
        <comment>2, 40 years</comment>
        <translation>
            <numerusform>Graine %1, %n an</numerusform>
            <numerusform>Graine %1, %n ans</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SelectTool</name>
    <message>
        <source>Everything in the box is selected · Shift: added</source>
        <translation>Tout ce qui est dans le cadre est sélectionné · Maj : ajouté</translation>
    </message>
    <message>
        <source>Shift: click adds or takes away, drag adds a box</source>
        <translation>Maj : un clic ajoute ou retire, glisser ajoute un cadre</translation>
    </message>
    <message>
        <source>Shift: drag adds a box</source>
        <translation>Maj : glisser ajoute un cadre</translation>
    </message>
    <message>
        <source>Click: select</source>
        <translation>Clic : sélectionner</translation>
    </message>
    <message>
        <source>Click: select nothing</source>
        <translation>Clic : ne rien sélectionner</translation>
    </message>
    <message>
        <source>Shift: add</source>
        <translation>Maj : ajouter</translation>
    </message>
    <message>
        <source>drag: box</source>
        <translation>glisser : cadre</translation>
    </message>
    <message>
        <source>Esc: only the tree</source>
        <translation>Échap : l’arbre seul</translation>
    </message>
    <message>
        <source>Click: limb · again: this branch of it</source>
        <translation>Clic : la branche entière · encore : ce tronçon seul</translation>
    </message>
</context>
<context>
    <name>ramure::SeparateDialog</name>
    <message>
        <source>Move colliding branches apart</source>
        <translation>Écarter les branches qui se heurtent</translation>
    </message>
    <message>
        <source>Turning branches and looking at the mesh again, until none collide or no turn helps…</source>
        <translation>Les branches sont tournées et le maillage examiné de nouveau, jusqu’à ce qu’aucune ne se heurte ou qu’aucune rotation n’aide…</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>No branches collide.</source>
        <translation>Aucune branche ne se heurte.</translation>
    </message>
    <message numerus="yes">
        <source>All %Ln colliding pair(s) moved apart</source>
        <translation>
            <numerusform>La paire qui se heurtait a été écartée</numerusform>
            <numerusform>Les %Ln paires qui se heurtaient ont été écartées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln colliding pair(s) moved apart; the rest are listed</source>
        <translation>
            <numerusform>%1 paire sur %Ln écartée ; le reste est dans la liste</numerusform>
            <numerusform>%1 paires sur %Ln écartées ; le reste est dans la liste</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::ShortcutsDialog</name>
    <message>
        <source>Changed; as supplied: %1</source>
        <translation>Modifié&#xa0;; à l’origine&#xa0;: %1</translation>
    </message>
    <message>
        <source>no keys</source>
        <translation>aucune touche</translation>
    </message>
    <message>
        <source>%1 already belongs to “%2”. Take it away there first, or choose other keys.</source>
        <translation>%1 appartient déjà à «&#xa0;%2&#xa0;». Retirez-le d’abord à cet endroit, ou choisissez d’autres touches.</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Search actions or keys</source>
        <translation>Chercher une action ou une touche</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>&amp;Keys:</source>
        <translation>&amp;Touches&#xa0;:</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Aucune touche</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout rétablir</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>These keys cannot be changed.</source>
        <translation>Ces touches ne peuvent pas être changées.</translation>
    </message>
</context>
<context>
    <name>ramure::SkyPictureActions</name>
    <message>
        <source>Sky picture</source>
        <translation>Image du ciel</translation>
    </message>
    <message>
        <source>Pictures of light (*.hdr *.exr);;All files (*)</source>
        <translation>Images de lumière (*.hdr *.exr);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The sky stays as it was</source>
        <translation>Le ciel reste comme il était</translation>
    </message>
    <message>
        <source>The picture has no sun: the light is soft and casts no shadow</source>
        <translation>L’image n’a pas de soleil : la lumière est douce et ne fait pas d’ombre</translation>
    </message>
    <message>
        <source>The picture&apos;s sun stands at %1°, %2° high</source>
        <translation>Le soleil de l’image est à %1°, à %2° de hauteur</translation>
    </message>
</context>
<context>
    <name>ramure::StatusPanel</name>
    <message>
        <source>Boundary edges</source>
        <translation>Arêtes de bord</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Arêtes non-variété</translation>
    </message>
    <message>
        <source>Non-manifold vertices</source>
        <translation>Sommets non-variété</translation>
    </message>
    <message>
        <source>Inconsistent edges</source>
        <translation>Arêtes incohérentes</translation>
    </message>
    <message>
        <source>Duplicate vertices</source>
        <translation>Sommets en double</translation>
    </message>
    <message>
        <source>Duplicate faces</source>
        <translation>Faces en double</translation>
    </message>
    <message>
        <source>Degenerate faces</source>
        <translation>Faces dégénérées</translation>
    </message>
    <message>
        <source>Isolated vertices</source>
        <translation>Sommets isolés</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Euler characteristic</source>
        <translation>Caractéristique d’Euler</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>The parameters give no tree; you see the last one that worked.</source>
        <translation>Les paramètres ne donnent pas d’arbre&#xa0;; vous voyez le dernier qui marchait.</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>calcul…</translation>
    </message>
    <message>
        <source>A quick draft is shown until the full result is there.</source>
        <translation>Une ébauche rapide est affichée en attendant le résultat complet.</translation>
    </message>
    <message>
        <source>Stop computing; the draft stays</source>
        <translation>Arrêter le calcul&#xa0;; l’ébauche reste</translation>
    </message>
    <message>
        <source>Stop computing</source>
        <translation>Arrêter le calcul</translation>
    </message>
    <message>
        <source>Progress of the computation</source>
        <translation>Progression du calcul</translation>
    </message>
    <message>
        <source>cached</source>
        <translation>en mémoire</translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branche</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message>
        <source>Time to build the trees, without drawing. “cached”: nothing had to be built, the results of before still hold.</source>
        <translation>Temps de construction des arbres, sans le dessin. «&#xa0;en mémoire&#xa0;» : rien n’était à construire, les résultats précédents sont toujours valables.</translation>
    </message>
    <message>
        <source>Hash of the mesh: %1</source>
        <translation>Empreinte du maillage : %1</translation>
    </message>
    <message>
        <source>Nothing visible</source>
        <translation>Rien de visible</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>faces</translation>
    </message>
    <message>
        <source>Counts of the visible nodes, as an export writes them. Branches are counted after simplification.</source>
        <translation>Nombres des nœuds visibles, tels qu’un export les écrit. Les branches sont comptées après simplification.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Closed, 2-manifold and outward: every edge has two faces. No triangle runs through another.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Fermé, 2-variété et tourné vers l’extérieur : chaque arête a deux faces. Aucun triangle n’en traverse un autre.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>&lt;p&gt;Closed, 2-manifold and outward: every edge has two faces. Whether triangles run through each other has not been looked for yet.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Fermé, 2-variété et tourné vers l’extérieur : chaque arête a deux faces. On n’a pas encore cherché si des triangles se traversent.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>défectueux</translation>
    </message>
    <message>
        <source>A click opens the Validation panel.</source>
        <translation>Un clic ouvre le panneau Validation.</translation>
    </message>
    <message>
        <source>Fruit</source>
        <translation>Fruits</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln triangle</numerusform>
            <numerusform>%Ln triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&lt;p&gt;Closed, 2-manifold and outward: every edge has two faces. %Ln pair(s) of triangles run through each other, as twigs do that touch: that matters for a print, which can be made without.&lt;/p&gt;</source>
        <translation>
            <numerusform>&lt;p&gt;Fermé, 2-variété et orienté vers l’extérieur : chaque arête a deux faces. %Ln paire de triangles se traverse, comme des rameaux qui se touchent : cela compte pour une impression, qui peut s’en défaire.&lt;/p&gt;</numerusform>
            <numerusform>&lt;p&gt;Fermé, 2-variété et orienté vers l’extérieur : chaque arête a deux faces. %Ln paires de triangles se traversent, comme des rameaux qui se touchent : cela compte pour une impression, qui peut s’en défaire.&lt;/p&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>Making the bark…</source>
        <translation>Écorce en cours…</translation>
    </message>
    <message>
        <source>The picture of the bark is being made; until it is there, the bark has one colour.</source>
        <translation>L’image de l’écorce est en préparation ; d’ici là, l’écorce est d’une seule couleur.</translation>
    </message>
</context>
<context>
    <name>ramure::StemCurves</name>
    <message>
        <source>How a stem of this level tapers and bends, without chance. Thickness is drawn larger.</source>
        <translation>Comment une tige de ce niveau s’amincit et se courbe, sans hasard. L’épaisseur est dessinée plus grande.</translation>
    </message>
    <message>
        <source>How far limbs reach from the trunk, by height. Dashed: the envelope that prunes them.</source>
        <translation>Jusqu’où les charpentières s’éloignent du tronc, selon la hauteur. En tirets : l’enveloppe qui les taille.</translation>
    </message>
</context>
<context>
    <name>ramure::StepForm</name>
    <message>
        <source>Step: %1</source>
        <translation>Étape : %1</translation>
    </message>
</context>
<context>
    <name>ramure::SurfacePreview</name>
    <message>
        <source>One leaf from above, without its neighbours</source>
        <translation>Une feuille vue de dessus, sans ses voisines</translation>
    </message>
    <message>
        <source>The bark on a ball, and one tile of it</source>
        <translation>L’écorce sur une boule, et un carreau</translation>
    </message>
    <message>
        <source>The surface on a ball, and one tile of it</source>
        <translation>La surface sur une boule, et un carreau</translation>
    </message>
    <message>
        <source>Larger…</source>
        <translation>En grand…</translation>
    </message>
    <message>
        <source>The leaf and a twig in a window of their own, which the properties shape</source>
        <translation>La feuille et un rameau dans une fenêtre à part, que les propriétés façonnent</translation>
    </message>
    <message>
        <source>One fruit or flower from the side, with its stalk</source>
        <translation>Un fruit ou une fleur de côté, avec sa tige</translation>
    </message>
</context>
<context>
    <name>ramure::TargetTool</name>
    <message>
        <source>The arm reaches for the point under the cursor · release: done</source>
        <translation>Le bras va vers le point sous le curseur · relâcher : terminer</translation>
    </message>
    <message>
        <source>Ctrl + click: target of the arm</source>
        <translation>Ctrl + clic : cible du bras</translation>
    </message>
    <message>
        <source>Ctrl: click or drag sets the target of the arm</source>
        <translation>Ctrl : un clic ou glisser place la cible du bras</translation>
    </message>
    <message>
        <source>Drag: the target of the arm moves across the view · Ctrl + click: onto a surface</source>
        <translation>Glisser : la cible du bras se déplace dans la vue · Ctrl + clic : sur une surface</translation>
    </message>
</context>
<context>
    <name>ramure::TimelinePanel</name>
    <message numerus="yes">
        <source>%n frame(s) dropped</source>
        <translation>
            <numerusform>%n image sautée</numerusform>
            <numerusform>%n images sautées</numerusform>
        </translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>The moment on show: frames, seconds (&quot;2 s&quot;) or timecode (&quot;0:02:00&quot;)</source>
        <translation>L&apos;instant montré : images, secondes («&#xa0;2 s&#xa0;») ou timecode («&#xa0;0:02:00&#xa0;»)</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>First frame that is played</source>
        <translation>Première image jouée</translation>
    </message>
    <message>
        <source>Last frame that is played</source>
        <translation>Dernière image jouée</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
    <message>
        <source>Frames per second, 1 to 240</source>
        <translation>Images par seconde, de 1 à 240</translation>
    </message>
    <message>
        <source>Common frame rates</source>
        <translation>Cadences courantes</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How fast time passes while playing, 0.1 to 4 times</source>
        <translation>Vitesse du temps pendant la lecture, de 0,1 à 4 fois</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Timecode</source>
        <translation>Timecode</translation>
    </message>
    <message>
        <source>How moments are shown</source>
        <translation>Comment les instants sont affichés</translation>
    </message>
    <message>
        <source>Behaviour at the last frame</source>
        <translation>Comportement à la dernière image</translation>
    </message>
    <message>
        <source>Give up computing; the frame on show stays</source>
        <translation>Abandonne le calcul ; l&apos;image montrée reste</translation>
    </message>
    <message>
        <source>Frames that came too late since playing began</source>
        <translation>Images arrivées trop tard depuis le début de la lecture</translation>
    </message>
</context>
<context>
    <name>ramure::TimelineRuler</name>
    <message>
        <source>Timeline ruler</source>
        <translation>Règle de la ligne de temps</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>calculée</translation>
    </message>
    <message>
        <source>computed for other parameters</source>
        <translation>calculée pour d&apos;autres paramètres</translation>
    </message>
    <message>
        <source>not computed yet</source>
        <translation>pas encore calculée</translation>
    </message>
    <message>
        <source>Frame %1, %2</source>
        <translation>Image %1, %2</translation>
    </message>
    <message>
        <source>a key</source>
        <translation>une clé</translation>
    </message>
</context>
<context>
    <name>ramure::ToolSettingsDialog</name>
    <message>
        <source>Steps and ghosts</source>
        <translation>Pas et fantômes</translation>
    </message>
    <message>
        <source>Dragging snaps to</source>
        <translation>Les gestes vont par pas de</translation>
    </message>
    <message>
        <source>Ghosts of moving nodes</source>
        <translation>Fantômes des nœuds animés</translation>
    </message>
    <message>
        <source>&amp;Move:</source>
        <translation>&amp;Déplacer :</translation>
    </message>
    <message>
        <source>&amp;Rotate:</source>
        <translation>&amp;Tourner :</translation>
    </message>
    <message>
        <source>&amp;Scale:</source>
        <translation>&amp;Échelle :</translation>
    </message>
    <message>
        <source>&amp;Before the playhead:</source>
        <translation>A&amp;vant la tête de lecture :</translation>
    </message>
    <message>
        <source>&amp;After the playhead:</source>
        <translation>A&amp;près la tête de lecture :</translation>
    </message>
    <message>
        <source>&amp;Every:</source>
        <translation>T&amp;outes les :</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> images</translation>
    </message>
    <message>
        <source>Moves go in steps of so many metres</source>
        <translation>Les déplacements vont par pas de tant de mètres</translation>
    </message>
    <message>
        <source>Turns go in steps of so many degrees</source>
        <translation>Les rotations vont par pas de tant de degrés</translation>
    </message>
    <message>
        <source>Factors go in steps of so much</source>
        <translation>Les facteurs vont par pas de tant</translation>
    </message>
    <message>
        <source>How many copies show where the node was, from 0 to %1</source>
        <translation>Combien de copies montrent où était le nœud, de 0 à %1</translation>
    </message>
    <message>
        <source>How many copies show where the node will be, from 0 to %1</source>
        <translation>Combien de copies montrent où sera le nœud, de 0 à %1</translation>
    </message>
    <message>
        <source>Frames from one copy to the next</source>
        <translation>Images d’une copie à la suivante</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>ramure::ToolStrip</name>
    <message>
        <source>More options</source>
        <translation>Plus d’options</translation>
    </message>
</context>
<context>
    <name>ramure::TransformActions</name>
    <message>
        <source>Trans&amp;form</source>
        <translation>Transfor&amp;mer</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Monde</translation>
    </message>
    <message>
        <source>Axes along which nodes are moved, turned and scaled</source>
        <translation>Axes selon lesquels les nœuds sont déplacés, tournés et mis à l’échelle</translation>
    </message>
    <message>
        <source>Axes of the tools</source>
        <translation>Axes des outils</translation>
    </message>
    <message>
        <source>&amp;Move %1</source>
        <translation>&amp;Déplacer %1</translation>
    </message>
    <message>
        <source>&amp;Rotate %1</source>
        <translation>&amp;Tourner %1</translation>
    </message>
    <message>
        <source>S&amp;cale %1</source>
        <translation>&amp;Redimensionner %1</translation>
    </message>
</context>
<context>
    <name>ramure::UnplacedButton</name>
    <message numerus="yes">
        <source>%Ln edit(s) without a place</source>
        <translation>
            <numerusform>%Ln modification sans place</numerusform>
            <numerusform>%Ln modifications sans place</numerusform>
        </translation>
    </message>
    <message>
        <source>Steps on limbs that are not there at present. They are kept. A click lists them.</source>
        <translation>Étapes sur des branches qui n’existent pas à présent. Elles sont conservées. Un clic les liste.</translation>
    </message>
</context>
<context>
    <name>ramure::UnplacedDialog</name>
    <message>
        <source>%1 %</source>
        <comment>a share</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Trunk of %1, %2 up</source>
        <translation>Tronc de %1, à %2 de sa hauteur</translation>
    </message>
    <message>
        <source>Limb of %1 that started %2 up the trunk</source>
        <translation>Charpentière de %1 qui partait à %2 du tronc</translation>
    </message>
    <message>
        <source>Branch of order %1, %2 long, that started %3 along the one below</source>
        <translation>Branche d’ordre %1, longue de %2, qui partait à %3 de celle d’en dessous</translation>
    </message>
    <message>
        <source>Edits without a place</source>
        <translation>Modifications sans place</translation>
    </message>
    <message>
        <source>These edits were made on branches that the tree has lost. They are kept with the project, and act again as soon as such a branch grows.</source>
        <translation>Ces modifications portaient sur des branches que l’arbre a perdues. Elles restent dans le projet et agissent de nouveau dès qu’une telle branche pousse.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modification</translation>
    </message>
    <message>
        <source>Where it was</source>
        <translation>Où elle était</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Deletes the selected edits (Del). Undo brings them back.</source>
        <translation>Supprime les modifications choisies (Suppr). Annuler les ramène.</translation>
    </message>
    <message>
        <source>Delete &amp;all</source>
        <translation>&amp;Tout supprimer</translation>
    </message>
    <message>
        <source>on a limb made by hand</source>
        <translation>sur une branche faite à la main</translation>
    </message>
</context>
<context>
    <name>ramure::ValidationPanel</name>
    <message>
        <source>What this means</source>
        <translation>Ce que cela veut dire</translation>
    </message>
    <message>
        <source>Choose a kind above to read its meaning and its effect.</source>
        <translation>Choisissez un genre ci-dessus pour lire ce qu’il veut dire et son effet.</translation>
    </message>
    <message>
        <source>Copy the report as text</source>
        <translation>Copier le rapport en texte</translation>
    </message>
    <message>
        <source>Defects and repairs</source>
        <translation>Défauts et réparations</translation>
    </message>
    <message>
        <source>Mesh check</source>
        <translation>Vérification du maillage</translation>
    </message>
    <message>
        <source>Report copied as text</source>
        <translation>Rapport copié en texte</translation>
    </message>
    <message>
        <source>The check of a mesh is shown here. The scene has no mesh.</source>
        <translation>Le contrôle d’un maillage se montre ici. La scène n’a pas de maillage.</translation>
    </message>
</context>
<context>
    <name>ramure::VariationsDialog</name>
    <message>
        <source>Variation with seed %1</source>
        <translation>Variation de graine %1</translation>
    </message>
    <message>
        <source>The tree in the scene grows like it. Undo brings the one before back.</source>
        <translation>L’arbre de la scène pousse comme elle. Annuler rend le précédent.</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1, graine %2</translation>
    </message>
    <message>
        <source>Kept in the gallery as &quot;%1&quot;.</source>
        <translation>Gardé dans la galerie sous le nom « %1 ».</translation>
    </message>
    <message>
        <source>Save the variations as a table</source>
        <translation>Enregistrer les variations en tableau</translation>
    </message>
    <message>
        <source>Tables for ramure-cli batch (*.csv)</source>
        <translation>Tableaux pour ramure-cli batch (*.csv)</translation>
    </message>
    <message numerus="yes">
        <source>%Ln tree(s) written: ramure-cli batch &quot;%1&quot; -o FOLDER grows them.</source>
        <translation>
            <numerusform>%Ln arbre écrit : ramure-cli batch &quot;%1&quot; -o DOSSIER le fait pousser.</numerusform>
            <numerusform>%Ln arbres écrits : ramure-cli batch &quot;%1&quot; -o DOSSIER les fait pousser.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take the &amp;star away</source>
        <translation>Retirer l’&amp;étoile</translation>
    </message>
    <message>
        <source>Set a &amp;star</source>
        <translation>Mettre une &amp;étoile</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Continuer</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Nothing but the places of its leaves varies by chance.</source>
        <translation>Seules les places de ses feuilles varient au hasard.</translation>
    </message>
    <message>
        <source>Growing %1 of %2 …</source>
        <translation>Pousse de %1 sur %2 …</translation>
    </message>
    <message numerus="yes">
        <source>%Ln tree(s), </source>
        <translation>
            <numerusform>%Ln arbre, </numerusform>
            <numerusform>%Ln arbres, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln with a star</source>
        <translation>
            <numerusform>%Ln avec une étoile</numerusform>
            <numerusform>%Ln avec une étoile</numerusform>
        </translation>
    </message>
    <message>
        <source>Variations of %1</source>
        <translation>Variations de %1</translation>
    </message>
    <message>
        <source>T&amp;rees:</source>
        <translation>A&amp;rbres :</translation>
    </message>
    <message>
        <source>How many, each with another seed; those with a star stay besides</source>
        <translation>Combien, chacun avec une autre graine ; ceux qui ont une étoile restent en plus</translation>
    </message>
    <message>
        <source>Other &amp;seeds</source>
        <translation>Autres &amp;graines</translation>
    </message>
    <message>
        <source>The seeds that follow; those with a star stay</source>
        <translation>Les graines suivantes ; ceux qui ont une étoile restent</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Open in place</source>
        <translation>&amp;Ouvrir sur place</translation>
    </message>
    <message>
        <source>The tree in the scene becomes this one (Return)</source>
        <translation>L’arbre de la scène devient celui-ci (Entrée)</translation>
    </message>
    <message>
        <source>&amp;Keep as preset</source>
        <translation>&amp;Garder comme modèle</translation>
    </message>
    <message>
        <source>Put it into the gallery</source>
        <translation>Le mettre dans la galerie</translation>
    </message>
    <message>
        <source>Save as ta&amp;ble</source>
        <translation>Enregistrer en ta&amp;bleau</translation>
    </message>
    <message>
        <source>Write a table, from which ramure-cli batch grows a file for each tree</source>
        <translation>Écrire un tableau dont ramure-cli batch tire un fichier par arbre</translation>
    </message>
    <message>
        <source>Save &amp;all as a table…</source>
        <translation>Enregistrer &amp;tous en tableau…</translation>
    </message>
    <message>
        <source>Save those &amp;with a star as a table…</source>
        <translation>Enregistrer ceux &amp;avec étoile en tableau…</translation>
    </message>
    <message>
        <source>Save those with&amp;out a star as a table…</source>
        <translation>Enregistrer ceux &amp;sans étoile en tableau…</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
</context>
<context>
    <name>ramure::VariationsModel</name>
    <message>
        <source>on</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>off</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Graine %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>Length: 3 m</comment>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Seed %1, %2</source>
        <comment>2, 40 years</comment>
        <translation>Graine %1, %2</translation>
    </message>
</context>
<context>
    <name>ramure::VariedParamsForm</name>
    <message>
        <source>%1: %2</source>
        <comment>Leaves: Size</comment>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Do not vary it</source>
        <translation>Ne pas le faire varier</translation>
    </message>
    <message>
        <source>Do not vary %1</source>
        <translation>Ne pas faire varier %1</translation>
    </message>
    <message>
        <source>on and off</source>
        <translation>oui et non</translation>
    </message>
    <message>
        <source>all of its values</source>
        <translation>toutes ses valeurs</translation>
    </message>
    <message>
        <source>to</source>
        <comment>from 1 m to 2 m</comment>
        <translation>à</translation>
    </message>
    <message>
        <source>The least value</source>
        <translation>La plus petite valeur</translation>
    </message>
    <message>
        <source>The greatest value</source>
        <translation>La plus grande valeur</translation>
    </message>
    <message>
        <source>Vary a parameter…</source>
        <translation>Faire varier un paramètre…</translation>
    </message>
    <message>
        <source>Choose a parameter, or type a part of its name and press Return</source>
        <translation>Choisissez un paramètre, ou tapez une partie de son nom puis Entrée</translation>
    </message>
    <message>
        <source>Parameter to vary</source>
        <translation>Paramètre à faire varier</translation>
    </message>
    <message>
        <source>Only chance varies: each tree has another seed. Add parameters above to spread their values too.</source>
        <translation>Seul le hasard varie : chaque arbre a une autre graine. Ajoutez des paramètres ci-dessus pour étaler aussi leurs valeurs.</translation>
    </message>
</context>
<context>
    <name>ramure::ViewActions</name>
    <message>
        <source>&amp;View from</source>
        <translation>&amp;Vue de</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>&amp;Angles in</source>
        <translation>An&amp;gles en</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>M&amp;ove the view</source>
        <translation>Dép&amp;lacer la vue</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <source>Wind of a ga&amp;me</source>
        <translation>Vent d’un &amp;jeu</translation>
    </message>
    <message>
        <source>The language changes when Ramure is started again.</source>
        <translation>La langue change au prochain démarrage de Ramure.</translation>
    </message>
    <message>
        <source>&amp;Draw as</source>
        <translation>&amp;Représentation</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Montrer</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualité</translation>
    </message>
</context>
<context>
    <name>ramure::ViewMenu</name>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Draw as</source>
        <translation>Représentation</translation>
    </message>
</context>
<context>
    <name>ramure::Viewport</name>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>There is no tree for a wind to blow on.</source>
        <translation>Il n&apos;y a pas d&apos;arbre sur lequel le vent pourrait souffler.</translation>
    </message>
    <message>
        <source>No wind blows in this scene: select a tree to set its wind with the arrow.</source>
        <translation>Aucun vent ne souffle dans cette scène : sélectionnez un arbre pour régler son vent avec la flèche.</translation>
    </message>
    <message>
        <source>Through “%1”</source>
        <translation>À travers « %1 »</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Vent : %1</translation>
    </message>
    <message>
        <source>Trees that the timeline moves do not stand in the wind of a game.</source>
        <translation>Les arbres que la ligne de temps fait bouger ne sont pas pris dans le vent d’un jeu.</translation>
    </message>
    <message>
        <source>This picture is out of date</source>
        <translation>Cette image n’est plus à jour</translation>
    </message>
    <message>
        <source>%1 copies, %2 in sight, %3 triangles</source>
        <translation>%1 copies, %2 en vue, %3 triangles</translation>
    </message>
</context>
<context>
    <name>ramure::ViewportHost</name>
    <message>
        <source>&lt;h3&gt;No 3D view&lt;/h3&gt;&lt;p&gt;%1&lt;/p&gt;&lt;p&gt;Everything else works: parameters, undo, saving and export.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Pas de vue 3D&lt;/h3&gt;&lt;p&gt;%1&lt;/p&gt;&lt;p&gt;Tout le reste fonctionne&#xa0;: paramètres, annulation, enregistrement et export.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>ramure::WelcomePanel</name>
    <message>
        <source>No files yet</source>
        <translation>Pas encore de fichier</translation>
    </message>
    <message>
        <source>Welcome to Ramure</source>
        <translation>Bienvenue dans Ramure</translation>
    </message>
    <message>
        <source>From a grammar to one clean mesh. The tree beside this page is ready to be changed.</source>
        <translation>D’une grammaire à un maillage propre. L’arbre à côté de cette page n’attend que vos changements.</translation>
    </message>
    <message>
        <source>Close this page (File menu: Welcome page)</source>
        <translation>Fermer cette page (menu Fichier&#xa0;: Page d’accueil)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>Keys to begin with</source>
        <translation>Touches pour commencer</translation>
    </message>
    <message>
        <source>Show this page at the start</source>
        <translation>Afficher cette page au démarrage</translation>
    </message>
    <message>
        <source>Begin a new scene with a tree</source>
        <translation>Commencer une scène avec un arbre</translation>
    </message>
    <message>
        <source>Click: new scene with it</source>
        <translation>Clic : nouvelle scène avec lui</translation>
    </message>
    <message>
        <source>&amp;Add to the scene</source>
        <translation>&amp;Ajouter à la scène</translation>
    </message>
</context>
<context>
    <name>ramure::WindTool</name>
    <message>
        <source>Change the wind</source>
        <translation>Modifier le vent</translation>
    </message>
    <message>
        <source>Length: strength of the wind, %1 × (about %2 m/s) · release: done</source>
        <translation>Longueur : force du vent, %1 × (environ %2 m/s) · relâcher : terminer</translation>
    </message>
</context>
<context>
    <name>render</name>
    <message>
        <source>This display cannot show OpenGL.</source>
        <translation>Cet affichage ne peut montrer OpenGL.</translation>
    </message>
    <message>
        <source>The graphics driver gives no OpenGL.</source>
        <translation>Le pilote graphique ne fournit pas OpenGL.</translation>
    </message>
    <message>
        <source>The graphics driver&apos;s OpenGL is older than 3.3.</source>
        <translation>L’OpenGL du pilote graphique est antérieur à la version 3.3.</translation>
    </message>
</context>
</TS>
