<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>trex_gui</name>
    <message><source>{0} is ambiguous: write {1} or {2}</source>
        <translation>{0} peut signifier {1} ou {2} : écrivez celui que vous voulez</translation></message>
    <message><source>{0} is not a number</source>
        <translation>{0} n'est pas un nombre</translation></message>
    <message><source>an empty text</source>
        <translation>vide</translation></message>
    <message><source>Internal error while searching {0} ({1}).</source>
        <translation>Erreur interne pendant la recherche sur {0} ({1}).</translation></message>
    <message><source>Permission denied for {0}. {1}</source>
        <translation>Permission refusée pour {0}. {1}</translation></message>
    <message><source>The port {0} cannot be reached: {1}.</source>
        <translation>Impossible de joindre le port {0} : {1}.</translation></message>
    <message><source>There is no port {0}. Ports of this computer: {1}.</source>
        <translation>Le port {0} n'existe pas. Ports de cet ordinateur : {1}.</translation></message>
    <message><source>{0} is in use by another program or locked by its driver. After a crash, the guardian process also uses it for up to 5 seconds to stop the motors. Close the other program or wait, then connect again.</source>
        <translation>{0} est utilisé par un autre programme ou verrouillé par son pilote ; jusqu'à 5 secondes après un plantage, il peut aussi l'être par le processus gardien qui arrête les moteurs.</translation></message>
    <message><source>Motors may still be turning: no stop has been confirmed for the {0} at {1}, driven since {2}. Stop the motors, or cut their power.</source>
        <translation>Des moteurs tournent peut-être encore : aucun arrêt de la carte {0} sur {1}, pilotée depuis {2}, n'est confirmé. Arrêtez-les, ou coupez leur alimentation.</translation></message>
    <message><source>Motors may still be turning: the file {0} shows that a board was left running, but the file is damaged and does not identify the board. If a motor is turning, cut its power. Then delete the file.</source>
        <translation>Des moteurs tournent peut-être encore : {0} indique qu'une carte est restée en marche, mais ce fichier est endommagé et ne dit pas laquelle. Si un moteur tourne, coupez son alimentation, puis supprimez le fichier.</translation></message>
    <message><source>The guardian process is still stopping the motors on {0}. Wait up to 5 seconds, then connect again.</source>
        <translation>Le processus gardien est encore en train d'arrêter les moteurs sur {0}, ce qui prend jusqu'à 5 secondes. Reconnectez ensuite.</translation></message>
    <message><source>{0} is in use by {1}. Close the port there, then connect again.</source>
        <translation>{0} est utilisé par {1}. Libérez-le d'abord, puis reconnectez.</translation></message>
    <message><source>The port {0} cannot be set to {1} ({2}).</source>
        <translation>Le port {0} ne peut pas être réglé sur {1} ({2}).</translation></message>
    <message><source>The port {0} cannot be opened: {1}.</source>
        <translation>Impossible d'ouvrir le port {0} : {1}.</translation></message>
    <message><source>Another program is also reading from {0} and has taken some of the bytes. Close that program, then connect again.</source>
        <translation>Un autre programme lit aussi {0} et en a pris des octets. Libérez-le dans ce programme, puis reconnectez.</translation></message>
    <message><source>The connection to {0} is gone. Plug the adapter in, then connect again.</source>
        <translation>La liaison avec {0} a disparu. Rebranchez le câble, puis reconnectez.</translation></message>
    <message><source>it is not an ordinary file</source>
        <translation>ce n'est pas un fichier ordinaire</translation></message>
    <message><source>this is a binary file; settings are text</source>
        <translation>c'est un fichier binaire ; les réglages sont du texte</translation></message>
    <message><source>this is UTF-16 text, as PowerShell writes with &gt;; save the file as UTF-8</source>
        <translation>c'est du texte UTF-16, comme PowerShell l'écrit avec &gt; ; enregistrez-le en UTF-8</translation></message>
    <message><source>it is a folder, not a file</source>
        <translation>c'est un dossier, pas un fichier</translation></message>
    <message><source>it cannot be read</source>
        <translation>le fichier ne peut pas être lu</translation></message>
    <message><source>it cannot be written</source>
        <translation>le fichier ne peut pas être écrit</translation></message>
    <message><source>warning</source>
        <translation>avertissement</translation></message>
    <message><source>it cannot be written: permission denied</source>
        <translation>le fichier ne peut pas être écrit : permission refusée</translation></message>
    <message><source>there is no such file</source>
        <translation>ce fichier n'existe pas</translation></message>
    <message><source>is larger than {0} KiB; {1} are never that large</source>
        <translation>dépasse {0} KiB ; ce contenu ({1}) n'est jamais aussi long</translation></message>
    <message><source>line {0}</source>
        <translation>ligne {0}</translation></message>
    <message><source>this is not UTF-8 text</source>
        <translation>ce n'est pas du texte UTF-8</translation></message>
    <message><source>there is no folder {0}</source>
        <translation>le dossier {0} n'existe pas</translation></message>
    <message><source>permission denied</source>
        <translation>permission refusée</translation></message>
    <message><source>The folder cannot be used: {0}.</source>
        <translation>Inutilisable : {0}.</translation></message>
    <message><source>Samples lost here because the disk was too slow: {0}.</source>
        <translation>Échantillons manquants ici, car le disque était trop lent : {0}.</translation></message>
    <message><source>This is not a TReX Studio recording.</source>
        <translation>Ce n'est pas un enregistrement de TReX Studio.</translation></message>
    <message><source>The file cannot be written: {0}.</source>
        <translation>Le fichier ne peut pas être écrit : {0}.</translation></message>
    <message><source>The file cannot be opened: {0}.</source>
        <translation>Impossible de l'ouvrir : {0}.</translation></message>
    <message><source>The file cannot be read: {0}.</source>
        <translation>Impossible à lire : {0}.</translation></message>
    <message><source>The file is damaged: {0}.</source>
        <translation>Il est endommagé : {0}.</translation></message>
    <message><source>its time is not a number</source>
        <translation>son temps n'est pas un nombre</translation></message>
    <message><source>The end of the file is missing.</source>
        <translation>La fin du fichier manque.</translation></message>
    <message><source>The log of the recording cannot be read, so the last samples are missing.</source>
        <translation>Son journal est illisible : les derniers échantillons manquent.</translation></message>
    <message><source>The recording was not closed properly. Samples from the last seconds may be missing.</source>
        <translation>Il n'a pas été terminé ; des échantillons des dernières secondes peuvent manquer.</translation></message>
    <message><source>the clock in the header is not in seconds</source>
        <translation>l'horloge de l'en-tête n'est pas en secondes</translation></message>
    <message><source>The column {0} is not the key of its table.</source>
        <translation>La colonne {0} n'est pas la clé de sa table.</translation></message>
    <message><source>its time is outside the recording</source>
        <translation>son temps n'est pas dans l'enregistrement</translation></message>
    <message><source>Record {0} cannot be read: {1}.</source>
        <translation>L'élément {0} est illisible : {1}.</translation></message>
    <message><source>{0} is not of type {1}</source>
        <translation>{0} n'est pas du type {1}</translation></message>
    <message><source>A CSV file is an export and cannot be opened as a recording. Open the original recording ({0}).</source>
        <translation>Un fichier CSV est un export et ne s'ouvre pas comme enregistrement. Ouvrez l'enregistrement ({0}) dont il provient.</translation></message>
    <message><source>The recording is still running. End the recording, then open the file again.</source>
        <translation>L'enregistrement est encore en cours. Terminez-le, puis ouvrez-le de nouveau.</translation></message>
    <message><source>The format of the file ({0}) is unknown. A later version of TReX Studio may be able to open the file.</source>
        <translation>Son format, {0}, est inconnu. Une version plus récente de TReX Studio peut peut-être l'ouvrir.</translation></message>
    <message><source>This is a recording of another device: {0}. Select the port or the demo of that device in the list of ports, then open the file again.</source>
        <translation>C'est l'enregistrement d'un autre appareil : {0}. Il s'ouvre lorsque la fenêtre montre les pages de cet appareil : choisissez son port ou sa démo dans la liste des ports, puis ouvrez de nouveau le fichier.</translation></message>
    <message><source>The table {0} is missing.</source>
        <translation>La table {0} manque.</translation></message>
    <message><source>The column {0} is missing.</source>
        <translation>La colonne {0} manque.</translation></message>
    <message><source>Samples of the kind {0} between records {1} and {2} are lost: {3}.</source>
        <translation>Des échantillons de {0} parmi les éléments {1} à {2} sont perdus : {3}.</translation></message>
    <message><source>The column {0} is computed, but it must be stored.</source>
        <translation>La colonne {0} est calculée.</translation></message>
    <message><source>The motors of the {0} at {1}, driven since {2}, were left running. The board now connected there has confirmed a stop. If a motor is still turning, cut its power.</source>
        <translation>Les moteurs de la carte {0} sur {1}, pilotée depuis {2}, étaient restés en marche. La carte qui s'y trouve maintenant a confirmé un arrêt. Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>Stop the motors first.</source>
        <translation>Il faut d'abord arrêter les moteurs.</translation></message>
    <message><source>another connection of this program</source>
        <translation>une autre liaison de ce programme</translation></message>
    <message><source>{0} (process {1})</source>
        <translation>{0} (processus {1})</translation></message>
    <message><source>Join the group of the port with this command, then log out and log in again: {0} (or grant access until the port is unplugged: {1}).</source>
        <translation>Rejoignez son groupe, puis fermez et rouvrez votre session : {0} (ou, jusqu'à ce qu'il soit débranché : {1}).</translation></message>
    <message><source>the server rejects the line settings</source>
        <translation>le serveur refuse les réglages de liaison</translation></message>
    <message><source>The port belongs to root. This command grants access until the port is unplugged: {0}</source>
        <translation>Il appartient à root ; cette commande l'ouvre jusqu'à ce qu'il soit débranché : {0}</translation></message>
    <message><source>none</source>
        <translation>aucun</translation></message>
    <message><source>another program</source>
        <translation>un autre programme</translation></message>
    <message><source>the server does not use RFC 2217</source>
        <translation>ce que le serveur envoie n'est pas du RFC 2217</translation></message>
    <message><source>the port accepts no data</source>
        <translation>le port n'accepte rien</translation></message>
    <message><source>the port cannot be set to {0}</source>
        <translation>le port ne peut pas être réglé sur {0}</translation></message>
    <message><source>The device sends data without being queried ({0} …).</source>
        <translation>L'appareil émet sans requête ({0} …).</translation></message>
    <message><source>even parity</source>
        <translation>parité paire</translation></message>
    <message><source>odd parity</source>
        <translation>parité impaire</translation></message>
    <message><source>2 stop bits</source>
        <translation>2 bits d'arrêt</translation></message>
    <message><source>no error detection</source>
        <translation>sans détection d'erreurs</translation></message>
    <message><source>1 stop bit</source>
        <translation>1 bit d'arrêt</translation></message>
    <message><source>{0} baud, {1}, {2}</source>
        <translation>{0} bauds, {1}, {2}</translation></message>
    <message><source>{0} at {1}</source>
        <translation>{0} à {1}</translation></message>
    <message><source>{0} baud</source>
        <translation>{0} bauds</translation></message>
    <message><source>Opened {0}.</source>
        <translation>Ouvert : {0}.</translation></message>
    <message><source>this is not a traffic log from the Traffic page or from trexcmd --traffic</source>
        <translation>ce n'est pas un journal de trafic : la page Trafic et trexcmd --traffic en créent</translation></message>
    <message><source>this is not a row of a traffic log</source>
        <translation>ce n'est pas une ligne d'un journal de trafic</translation></message>
    <message><source>{0} cannot be written: {1}.</source>
        <translation>{0} ne peut pas être écrit : {1}.</translation></message>
    <message><source>Other users of this computer can read your secrets. Prevent this with the command: chmod 600 “{0}”</source>
        <translation>D’autres utilisateurs de cet ordinateur peuvent lire les secrets : chmod 600 « {0} ».</translation></message>
    <message><source>{0} does not have the form trex://host/name, such as trex://robot.local/arm.</source>
        <translation>{0} n'est pas trex://hôte/nom, par exemple trex://robot.local/arm.</translation></message>
    <message><source>{0}: {1!r} is not a kind of port; try socket:// or rfc2217://.</source>
        <translation>{0} : ce type de port n'existe pas ({1!r}) ; essayez socket:// ou rfc2217://.</translation></message>
    <message><source>{0} does not have the form {1}://host:port, such as {1}://192.168.1.20:2217.</source>
        <translation>{0} n'est pas de la forme {1}://hôte:port, par exemple {1}://192.168.1.20:2217.</translation></message>
    <message><source>{0} is not the name of a host, such as robot.local.</source>
        <translation>{0} n'est pas un hôte, par exemple robot.local.</translation></message>
    <message><source>Opening this port reset the board. The board responds again after about a second.</source>
        <translation>L'ouverture de ce port a réinitialisé la carte : elle répond environ une seconde plus tard.</translation></message>
    <message><source>Aracna {0}</source>
        <translation>Aracna {0}</translation></message>
    <message><source>No probe for an Aracna was sent on {0}: the baud rate is set at the other end of the network, and a TReX at another rate could mistake the probe for a command. If you know that the device is an Aracna, connect once with: trex-gui --device aracna --port {1}</source>
        <translation>Aucune requête de détection d'un Aracna n'a été envoyée sur {0} : le débit est réglé à l'autre bout du réseau, et un TReX à un autre débit pourrait prendre cette requête pour une commande. Si vous savez que c'est un Aracna, connectez-le une fois avec : trex-gui --device aracna --port {1}</translation></message>
    <message><source>No probe for an Aracna was sent: {0} cannot be set to {1}.</source>
        <translation>Aucune requête de détection d'un Aracna n'a été envoyée : {0} ne peut pas être réglé sur {1}.</translation></message>
    <message><source>Rename {0}</source>
        <translation>Renommer {0}</translation></message>
    <message><source>Duplicate {0}</source>
        <translation>Dupliquer {0}</translation></message>
    <message><source>Delete {0}</source>
        <translation>Supprimer {0}</translation></message>
    <message><source>Move {0}</source>
        <translation>Déplacer {0}</translation></message>
    <message><source>pose</source>
        <translation>pose</translation></message>
    <message><source>Add pose {0}</source>
        <translation>Ajouter la pose {0}</translation></message>
    <message><source>Change pose {0}</source>
        <translation>Modifier la pose {0}</translation></message>
    <message><source>sequence</source>
        <translation>séquence</translation></message>
    <message><source>Change sequence {0}</source>
        <translation>Modifier la séquence {0}</translation></message>
    <message><source>Add sequence {0}</source>
        <translation>Ajouter la séquence {0}</translation></message>
    <message><source>Motor {0}</source>
        <translation>Moteur {0}</translation></message>
    <message><source>The recording ends here.</source>
        <translation>L'enregistrement se termine ici.</translation></message>
    <message><source>Recording {0} ended because the connection was closed.</source>
        <translation>Enregistrement {0} terminé avec la connexion.</translation></message>
    <message><source>Recording {0} ended: the number of motors has changed.</source>
        <translation>Enregistrement {0} terminé : le nombre de moteurs a changé.</translation></message>
    <message numerus="yes"><source>%n time(s)</source>
        <translation><numerusform>%n fois</numerusform><numerusform>%n fois</numerusform></translation></message>
    <message><source>repeating</source>
        <translation>en boucle</translation></message>
    <message><source>slowly to the start</source>
        <translation>lentement jusqu'au départ</translation></message>
    <message><source>A running motion continues to its goal.</source>
        <translation>Un mouvement en cours continue jusqu'à sa cible.</translation></message>
    <message><source>No robot is connected.</source>
        <translation>Aucun robot n'est connecté.</translation></message>
    <message numerus="yes"><source>Connected to Aracna: firmware {0}, %n motor(s).</source>
        <translation><numerusform>Connecté à l'Aracna : firmware {0}, %n moteur.</numerusform><numerusform>Connecté à l'Aracna : firmware {0}, %n moteurs.</numerusform></translation></message>
    <message><source>The board has restarted; it is ready again in a second …</source>
        <translation>La carte a redémarré ; elle sera prête dans une seconde …</translation></message>
    <message><source>The robot is not responding. Is its power on? Waiting for it …</source>
        <translation>Le robot ne répond pas. Est-il sous tension ? Attente …</translation></message>
    <message numerus="yes"><source>Clamped to the limits of the joints: %n step(s).</source>
        <translation><numerusform>Ramenée aux limites des articulations : %n étape.</numerusform><numerusform>Ramenées aux limites des articulations : %n étapes.</numerusform></translation></message>
    <message><source>Speeds not set: {0}</source>
        <translation>Vitesses non réglées : {0}</translation></message>
    <message><source>LED not switched: {0}</source>
        <translation>LED non commutée : {0}</translation></message>
    <message><source>Not moved: {0}</source>
        <translation>Pas de mouvement : {0}</translation></message>
    <message><source>Aborted: {0}</source>
        <translation>Interrompu : {0}</translation></message>
    <message><source>Move to {0}.</source>
        <translation>Aller à {0}.</translation></message>
    <message numerus="yes"><source>Playing %n step(s), {0}.</source>
        <translation><numerusform>Lecture de %n étape, {0}.</numerusform><numerusform>Lecture de %n étapes, {0}.</numerusform></translation></message>
    <message><source>Nothing more is sent.</source>
        <translation>Plus rien n'est envoyé.</translation></message>
    <message><source>Solid lines: last reported positions. Dashed lines: goals. In this sketch, all angles are drawn flat.</source>
        <translation>Traits pleins : dernières positions transmises ; tirets : cible. Schéma : les angles sont dessinés à plat.</translation></message>
    <message><source>The order of the legs is assumed. Even motors are inner joints, odd motors are outer joints.</source>
        <translation>L'attribution des pattes est supposée ; les moteurs pairs sont les articulations intérieures, les impairs les extérieures.</translation></message>
    <message><source>The motion ends by itself in about {0:.1f} s.</source>
        <translation>Le mouvement se termine de lui-même dans {0:.1f} s environ.</translation></message>
    <message><source>Playing step {0} of {1} “{2}”, round {3} of {4}.</source>
        <translation>Étape {0} sur {1} « {2} » en cours, cycle {3} sur {4}.</translation></message>
    <message><source>Check its power and the cable.</source>
        <translation>Vérifiez son alimentation et le câble.</translation></message>
    <message><source>unlimited</source>
        <translation>illimitée</translation></message>
    <message><source>The reply was lost, or no motor responds. The positions are unknown.</source>
        <translation>La réponse s'est perdue (ou aucun moteur ne répond) : les positions ne sont pas connues.</translation></message>
    <message><source>Unknown: a motion may continue for about {0:.0f} s.</source>
        <translation>Inconnu : un mouvement peut continuer pendant environ {0:.0f} s.</translation></message>
    <message><source>Nothing is sent. The robot may be moving: its state is unknown until its first move.</source>
        <translation>Rien n'est envoyé. On ne sait pas s'il bouge avant son premier mouvement.</translation></message>
    <message><source>The robot does not respond.</source>
        <translation>Le robot ne répond pas.</translation></message>
    <message><source>Check the servo power, the cable, and whether the servo is blocked. Resetting the board ends the wait, but does not stop the servos.</source>
        <translation>Vérifiez l'alimentation des servos, le câble, et s'il est bloqué. Une réinitialisation de la carte met fin à l'attente ; elle n'arrête pas les servos.</translation></message>
    <message><source>Motor {0}, {1} leg</source>
        <translation>Moteur {0}, patte {1}</translation></message>
    <message><source>stuck here</source>
        <translation>figé ici</translation></message>
    <message><source>no reply (−1)</source>
        <translation>pas de réponse (−1)</translation></message>
    <message><source>At rest: nothing is sent.</source>
        <translation>Au repos : rien n'est envoyé.</translation></message>
    <message><source>Unknown: the last motion may still be running.</source>
        <translation>Inconnu : le dernier mouvement est peut-être encore en cours.</translation></message>
    <message><source>The sequence starts.</source>
        <translation>La séquence commence.</translation></message>
    <message><source>Playing blend-in.</source>
        <translation>Transition d'entrée en cours.</translation></message>
    <message><source>Playing blend-out.</source>
        <translation>Transition de sortie en cours.</translation></message>
    <message><source>Clamped to the limits of the joints: {0}.</source>
        <translation>Ramené aux limites des articulations : {0}.</translation></message>
    <message><source>The board has restarted. Its servos continue to their goals.</source>
        <translation>La carte a redémarré. Ses servos continuent jusqu'à leurs cibles.</translation></message>
    <message><source>outer</source>
        <translation>extérieur</translation></message>
    <message><source>inner</source>
        <translation>intérieur</translation></message>
    <message><source>moving …</source>
        <translation>en mouvement …</translation></message>
    <message><source>Playing step {0}, round {1}.</source>
        <translation>Étape {0} en cours, cycle {1}.</translation></message>
    <message><source>motor {0} to {1} instead of {2}</source>
        <translation>moteur {0} à {1} au lieu de {2}</translation></message>
    <message><source>missed by {0}</source>
        <translation>{0} : manquée</translation></message>
    <message><source>Waiting for motor {0} to arrive …</source>
        <translation>En attente de l'arrivée du moteur {0} …</translation></message>
    <message><source>Lies down flat in 3 s and stands up in 3 s, from any position.</source>
        <translation>Se couche à plat en 3 s et se relève en 3 s, depuis n'importe quelle position.</translation></message>
    <message><source>Lifts two opposite legs, swings the other two, changes over and swings them back.</source>
        <translation>Lève deux pattes opposées, fait pivoter les deux autres, alterne et les ramène.</translation></message>
    <message><source>Moves all motors together, up to 100 units to either side of the centre.</source>
        <translation>Tous les moteurs ensemble, ±100 unités autour du centre.</translation></message>
    <message><source>Moves back and forth between two poses; a motor that ends more than 50 units from its goal is suspect.</source>
        <translation>Va-et-vient entre deux poses ; les moteurs qui restent à plus de 50 unités de leur cible sont suspects.</translation></message>
    <message><source>Moves down to half-stand and up again.</source>
        <translation>Descend à la pose « half-stand » et remonte.</translation></message>
    <message><source>Moves through half-stand to flat, from any position.</source>
        <translation>Passe par « half-stand » jusqu'à « flat », depuis n'importe quelle position.</translation></message>
    <message><source>The poses are for {0} motors, but the robot has {1}: the last positions are ignored.</source>
        <translation>Les poses sont pour {0} moteurs, le robot en a {1} : les dernières positions sont ignorées.</translation></message>
    <message><source>The poses are for {0} motors, but the robot has {1}: the remaining motors go to {2}.</source>
        <translation>Les poses sont pour {0} moteurs, le robot en a {1} : ses derniers moteurs vont à {2}.</translation></message>
    <message><source>{0} uses poses that are not defined: {1}</source>
        <translation>{0} utilise des poses qui ne sont pas définies : {1}</translation></message>
    <message><source>{0} has no steps</source>
        <translation>{0} n'a aucune étape</translation></message>
    <message><source>the first line should contain the name of the robot and the number of servos; assuming 8 servos</source>
        <translation>la première ligne devrait nommer le robot et ses servos ; 8 servos sont supposés</translation></message>
    <message><source>poses</source>
        <translation>poses</translation></message>
    <message><source>this is neither a pose nor a sequence: there is no colon</source>
        <translation>ni une pose ni une séquence : il manque le deux-points</translation></message>
    <message><source>a sequence needs a colon after its name</source>
        <translation>une séquence a un deux-points après son nom</translation></message>
    <message><source>this text is not in UTF-8; it was read as Western European, and will be saved as UTF-8</source>
        <translation>ce n'est pas du texte UTF-8 ; il est lu comme texte d'Europe occidentale, et « Enregistrer » écrit de l'UTF-8</translation></message>
    <message><source>this is a binary file, but pose files contain text</source>
        <translation>c'est un fichier binaire ; les poses sont du texte</translation></message>
    <message><source>{0} resolutions are expected; assuming {1} for every servo</source>
        <translation>{0} résolutions attendues ; {1} est supposé pour chaque servo</translation></message>
    <message><source>pose {0} has only {1} of {2} positions; the missing positions become {3}</source>
        <translation>la pose {0} a {1} positions sur {2} ; celles qui manquent deviennent {3}</translation></message>
    <message><source>pose {0}: positions must be numbers from 0 to {1}, not {2!r} (motor {3})</source>
        <translation>pose {0} : les positions sont des nombres de 0 à {1}, pas {2!r} (moteur {3})</translation></message>
    <message><source>sequence {0}: a step must be a pose, a bar and {1} to {2} ms, not {3!r}</source>
        <translation>séquence {0} : une étape se compose d'une pose, d'une barre et de {1} à {2} ms, pas {3!r}</translation></message>
    <message><source>pose {0} has {1} positions for {2} servos; the last positions are kept, but not used</source>
        <translation>la pose {0} a {1} positions pour {2} servos ; les dernières sont conservées, mais pas utilisées</translation></message>
    <message><source>line {0} defines this {1} again and takes precedence; the name in this line becomes {2}</source>
        <translation>la ligne {0} contient de nouveau cette {1} et compte ; celle-ci s'appelle maintenant {2}</translation></message>
    <message><source>sequence {0} uses the pose {1}, which is not in the file</source>
        <translation>la séquence {0} utilise la pose {1}, qui n'est pas dans le fichier</translation></message>
    <message><source>a {0} needs a name before the colon</source>
        <translation>une {0} a un nom avant son deux-points</translation></message>
    <message><source>{0}; the line is kept, but not used</source>
        <translation>{0} ; la ligne est conservée, mais pas utilisée</translation></message>
    <message><source>a name must have 1 to {0} printable characters, without colon, comma or bar</source>
        <translation>un nom a de 1 à {0} caractères imprimables, sans deux-points, virgule ni barre</translation></message>
    <message><source>the name {0} is taken</source>
        <translation>le nom {0} est déjà pris</translation></message>
    <message><source>the speed of motor {0} must be 0 to {1}, not {2}</source>
        <translation>la vitesse du moteur {0} va de 0 à {1}, et non {2}</translation></message>
    <message><source>the position of motor {0} must be 0 to {1}, not {2}</source>
        <translation>la position du moteur {0} va de 0 à {1}, et non {2}</translation></message>
    <message><source>{0} motors need {0} values, not {1}</source>
        <translation>{0} moteurs demandent {0} valeurs, et non {1}</translation></message>
    <message><source>Front left</source>
        <translation>Avant gauche</translation></message>
    <message><source>Front right</source>
        <translation>Avant droite</translation></message>
    <message><source>Back right</source>
        <translation>Arrière droite</translation></message>
    <message><source>Back left</source>
        <translation>Arrière gauche</translation></message>
    <message><source>limits must be 0 to {0}, the lower one first, not {1} to {2}</source>
        <translation>les limites vont de 0 à {0}, dans l'ordre, pas de {1} à {2}</translation></message>
    <message><source>No Aracna responds on {0}. If the robot is moving, wait until it stops: it does not listen while it moves. Check that the robot's board has power, that the adapter's TX is connected to the board's RX and the adapter's RX to the board's TX (or that both radios are on the same channel), and that ground is connected.</source>
        <translation>Aucun Aracna ne répond sur {0}. Il n'écoute pas pendant qu'il bouge : s'il bouge, attendez qu'il s'arrête. Vérifiez que la carte du robot est alimentée, que TX de l'adaptateur va à son RX et RX à son TX (ou que les deux radios sont sur le même canal), et que la masse est reliée.</translation></message>
    <message><source>No Aracna responds on {0}: everything sent comes back, and nothing else arrives. The adapter's TX and RX are joined; an Aracna never echoes.</source>
        <translation>Aucun Aracna ne répond sur {0} : tout ce qui est envoyé revient, et rien d'autre. Les broches TX et RX de l'adaptateur sont reliées ; un Aracna ne renvoie jamais d'écho.</translation></message>
    <message><source>An Aracna on {0} reports that it has started, but does not respond afterwards. It may be restarting repeatedly. Check its power supply.</source>
        <translation>Un Aracna sur {0} signale qu'il démarre, mais ne répond pas ensuite. Il redémarre peut-être sans cesse : vérifiez son alimentation.</translation></message>
    <message><source>A reply arrived on {0}, but not from an Aracna: {1}. The cause may be another device, perhaps a TReX at another baud rate, or interference on the line.</source>
        <translation>Quelque chose répond sur {0}, mais pas comme un Aracna : {1}. C'est un autre appareil, peut-être un TReX à un autre débit, ou des parasites sur la liaison.</translation></message>
    <message><source>The robot has not replied yet. Wait until it responds, then try again.</source>
        <translation>Le robot n'a pas encore répondu ; il est encore interrogé.</translation></message>
    <message><source>The robot has not yet replied to the last command.</source>
        <translation>Une commande à la fois : le robot n'a pas encore répondu à la dernière.</translation></message>
    <message><source>The robot did not reply in time.</source>
        <translation>Le robot n'a pas répondu à temps.</translation></message>
    <message><source>The reply does not match the command: {0}.</source>
        <translation>La réponse ne correspond pas à la commande : {0}.</translation></message>
    <message><source>The robot is waiting for motor {0} and reads no commands until this motor responds.</source>
        <translation>Le robot attend le moteur {0} et ne lit rien tant que celui-ci ne répond pas.</translation></message>
    <message><source>The robot is stuck: nothing was sent.</source>
        <translation>Le robot est figé : rien n'a été envoyé.</translation></message>
    <message><source>Motor {0} did not accept speed {1}; it still has speed {2}.</source>
        <translation>Le moteur {0} n'a pas accepté la vitesse {1} ; il garde la vitesse {2}.</translation></message>
    <message><source>Motor {0} did not accept speed {1}: it does not respond.</source>
        <translation>Le moteur {0} n'a pas accepté la vitesse {1} : il ne répond pas.</translation></message>
    <message><source>No motor accepted its speed. Check the servo power.</source>
        <translation>Aucun moteur n'a accepté sa vitesse. Vérifiez l'alimentation des servos.</translation></message>
    <message><source>The robot did not confirm its speeds, so no motor was moved. {0}</source>
        <translation>Le robot n'a pas confirmé ses vitesses ; aucun moteur n'a donc été déplacé. {0}</translation></message>
    <message><source>{0} The motor is blocked, or servo power was off. Remove the cause, then play the sequence again.</source>
        <translation>{0} Il est bloqué, ou les servos n'étaient pas alimentés. La séquence ne reprend pas d'elle-même.</translation></message>
    <message><source>Motor {0} is at {1}, {2} from its goal {3}.</source>
        <translation>Le moteur {0} est à {1}, soit {2} par rapport à sa cible {3}.</translation></message>
    <message><source>Motor {0} did not report its position (−1).</source>
        <translation>Le moteur {0} n'a pas transmis sa position (−1).</translation></message>
    <message><source>A sequence is playing: stop it first.</source>
        <translation>Une séquence est en cours : arrêtez-la d'abord.</translation></message>
    <message><source>A newer request replaced this one.</source>
        <translation>Une demande plus récente a remplacé celle-ci.</translation></message>
    <message><source>Stopped before the command was sent.</source>
        <translation>Arrêté avant l'envoi.</translation></message>
    <message><source>The robot's board has restarted.</source>
        <translation>La carte du robot a redémarré.</translation></message>
    <message><source>Another robot now responds on this port.</source>
        <translation>Un autre robot répond maintenant sur ce port.</translation></message>
    <message><source>The robot stopped responding.</source>
        <translation>Le robot a cessé de répondre.</translation></message>
    <message><source>The connection was closed before the request was complete.</source>
        <translation>La connexion a été fermée avant que ce soit fait.</translation></message>
    <message><source>Internal error in the connection: {0}</source>
        <translation>Erreur interne de la connexion : {0}</translation></message>
    <message><source>Played to the end.</source>
        <translation>Joué jusqu'à la fin.</translation></message>
    <message><source>The sequence ended after the current step.</source>
        <translation>La séquence s'est terminée après son étape.</translation></message>
    <message><source>The sequence was stopped.</source>
        <translation>La séquence a été arrêtée.</translation></message>
    <message><source>The sequence was aborted: the board has restarted.</source>
        <translation>La séquence a été interrompue : la carte a redémarré.</translation></message>
    <message><source>The sequence was aborted: the robot is waiting for a motor.</source>
        <translation>La séquence a été interrompue : le robot attend un moteur.</translation></message>
    <message><source>The sequence was aborted: a motor did not accept its speed.</source>
        <translation>La séquence a été interrompue : un moteur n'a pas accepté sa vitesse.</translation></message>
    <message><source>The sequence was aborted: a motor was far from its goal.</source>
        <translation>La séquence a été interrompue : un moteur était loin de sa cible.</translation></message>
    <message><source>The sequence was aborted: the robot does not respond.</source>
        <translation>La séquence a été interrompue : le robot ne répond pas.</translation></message>
    <message><source>A robot with {0} motors cannot play this sequence.</source>
        <translation>Un robot à {0} moteurs ne peut pas exécuter cela.</translation></message>
    <message><source>query version and motors</source>
        <translation>demander la version et les moteurs</translation></message>
    <message><source>switch the debug LED on</source>
        <translation>allumer la LED de débogage</translation></message>
    <message><source>switch the debug LED off</source>
        <translation>éteindre la LED de débogage</translation></message>
    <message><source>end an unfinished line in the robot's buffer</source>
        <translation>terminer une ligne inachevée dans le tampon du robot</translation></message>
    <message><source>not an Aracna command</source>
        <translation>pas une commande d'un Aracna</translation></message>
    <message><source>the robot has started and is busy for a second</source>
        <translation>le robot a démarré, occupé pendant une seconde</translation></message>
    <message><source>{0}, then query whether the robot is free</source>
        <translation>{0}, puis demander s'il est libre</translation></message>
    <message><source>no reply</source>
        <translation>pas de réponse</translation></message>
    <message><source>incomplete reply</source>
        <translation>réponse incomplète</translation></message>
    <message><source>no reply to the command itself</source>
        <translation>pas de réponse à la commande elle-même</translation></message>
    <message><source>1 motor</source>
        <translation>1 moteur</translation></message>
    <message><source>the LED is on</source>
        <translation>la LED est allumée</translation></message>
    <message><source>the LED is off</source>
        <translation>la LED est éteinte</translation></message>
    <message><source>go to {0}</source>
        <translation>aller à {0}</translation></message>
    <message><source>set speeds {0}</source>
        <translation>régler les vitesses {0}</translation></message>
    <message><source>unsolicited: {0}</source>
        <translation>non sollicité : {0}</translation></message>
    <message><source>firmware {0}, {1}</source>
        <translation>firmware {0}, {1}</translation></message>
    <message><source>firmware {0}</source>
        <translation>firmware {0}</translation></message>
    <message><source>speeds {0}</source>
        <translation>vitesses {0}</translation></message>
    <message><source>at {0}</source>
        <translation>à {0}</translation></message>
    <message><source>not a reply from an Aracna: {0}</source>
        <translation>pas une réponse d'un Aracna : {0}</translation></message>
    <message><source>incomplete line: {0}</source>
        <translation>ligne incomplète : {0}</translation></message>
    <message><source>{0} motors</source>
        <translation>{0} moteurs</translation></message>
    <message><source>followed by {0}</source>
        <translation>suivi de {0}</translation></message>
    <message><source>Percentage of bytes that are corrupted, in both directions. The protocol does not detect corrupted bytes, and a corrupted command may restart the firmware.</source>
        <translation>Cette part des octets est altérée dans les deux sens ; ce protocole ne le détecte pas, et une commande altérée peut redémarrer le firmware</translation></message>
    <message><source>A command that loses a byte may have too few values, which restarts the firmware</source>
        <translation>Un octet perdu d'une commande peut y laisser trop peu de valeurs, ce qui redémarre le firmware</translation></message>
    <message><source>To stop a motion, switch off the servo power: the protocol has no stop command.</source>
        <translation>Le seul moyen d'arrêter un mouvement : le protocole n'a pas de commande d'arrêt.</translation></message>
    <message><source>The debug LED; it blinks while the firmware boots</source>
        <translation>La LED de débogage ; elle clignote pendant le démarrage du firmware</translation></message>
    <message><source>Power</source>
        <translation>Alimentation</translation></message>
    <message><source>Robot on</source>
        <translation>Robot en marche</translation></message>
    <message><source>The robot's power switch, for board and servos</source>
        <translation>L'interrupteur du robot : carte et servos</translation></message>
    <message><source>Restart board</source>
        <translation>Redémarrer la carte</translation></message>
    <message><source>Servo power</source>
        <translation>Alimentation des servos</translation></message>
    <message><source>Power of the servos only. Without power, the servos stop, go limp and lose their speeds, and the firmware waits for them.</source>
        <translation>L'alimentation des servos seuls : sans elle, ils s'arrêtent, ne tiennent plus et perdent leurs vitesses ; le firmware les attend</translation></message>
    <message><source>Dead</source>
        <translation>En panne</translation></message>
    <message><source>Blocked</source>
        <translation>Bloqué</translation></message>
    <message><source>Servos</source>
        <translation>Servos</translation></message>
    <message><source>Real position</source>
        <translation>Position réelle</translation></message>
    <message><source>Cable</source>
        <translation>Câble</translation></message>
    <message><source>Plugged in</source>
        <translation>Branché</translation></message>
    <message><source>When the cable is unplugged, the port disappears, but a running motion continues to its goal</source>
        <translation>Débranché, le port disparaît ; un mouvement en cours continue jusqu'à sa cible</translation></message>
    <message><source>Moving indefinitely: waiting for a servo that is blocked or dead.</source>
        <translation>Mouvement sans fin : en attente d'un servo bloqué ou en panne.</translation></message>
    <message><source>no power</source>
        <translation>pas d'alimentation</translation></message>
    <message><source>Clear all faults</source>
        <translation>Supprimer tous les défauts</translation></message>
    <message><source>Noise</source>
        <translation>Bruit</translation></message>
    <message><source>LED: on</source>
        <translation>LED : allumée</translation></message>
    <message><source>LED: off</source>
        <translation>LED : éteinte</translation></message>
    <message><source>LED: blinks</source>
        <translation>LED : clignote</translation></message>
    <message><source>Robot switched on</source>
        <translation>Robot en marche</translation></message>
    <message><source>Reset the board: the firmware restarts, but the servos continue to their goals</source>
        <translation>La ligne de réinitialisation : le firmware redémarre, les servos continuent jusqu'à leurs cibles</translation></message>
    <message><source>{0}: real position</source>
        <translation>{0} : position réelle</translation></message>
    <message><source>Cable plugged in</source>
        <translation>Câble branché</translation></message>
    <message><source>The return wire is broken: the robot executes commands, but no reply arrives</source>
        <translation>Le fil de retour est coupé : le robot exécute les commandes, aucune réponse n'arrive</translation></message>
    <message><source>Moving indefinitely: waiting for servos that have no power.</source>
        <translation>Mouvement sans fin : en attente de servos sans alimentation.</translation></message>
    <message><source>The power is off: the robot does not reply, and no servo holds its position.</source>
        <translation>L'alimentation est coupée : pas de réponse, et aucun servo ne tient.</translation></message>
    <message><source>Booting: blinks for a second and reads nothing.</source>
        <translation>Démarrage : clignote pendant une seconde et ne lit rien.</translation></message>
    <message><source>Idle: waiting for commands.</source>
        <translation>Inactif : en attente de commandes.</translation></message>
    <message><source>Setting speeds and reading them back from the servos.</source>
        <translation>Réglage des vitesses : elles sont relues dans les servos.</translation></message>
    <message><source>Moving: reads nothing until every servo has arrived.</source>
        <translation>En mouvement : ne lit rien avant que tous les servos soient arrivés.</translation></message>
    <message><source>The robot's switch is off: board and servos have no power.</source>
        <translation>L'interrupteur du robot est sur arrêt : carte et servos ne sont pas alimentés.</translation></message>
    <message><source>Servo power is off: no servo moves, holds its position or replies.</source>
        <translation>Coupée : aucun servo ne bouge, ne tient ni ne répond.</translation></message>
    <message><source>dead</source>
        <translation>en panne</translation></message>
    <message><source>Number of times that the firmware has started</source>
        <translation>Nombre de démarrages du firmware</translation></message>
    <message><source>Repair and free every servo, clear all line faults, and switch everything on</source>
        <translation>Servos en état, libres et sans charge, liaison sans bruit, tout en marche</translation></message>
    <message><source>{0} does not respond, as if it were unplugged: its speed reads as −1, and a move waits indefinitely</source>
        <translation>{0} ne répond pas, comme débranché : les vitesses lues valent −1, et un mouvement l'attend sans fin</translation></message>
    <message><source>{0} is blocked: it remains “moving”, and the firmware waits</source>
        <translation>Quelque chose bloque {0} : il reste « en mouvement », et le firmware attend</translation></message>
    <message><source>Simulated loss</source>
        <translation>Perte à simuler</translation></message>
    <message><source>Lose</source>
        <translation>Le perdre</translation></message>
    <message><source>Takes effect in the next transfer</source>
        <translation>Prend effet au prochain transfert</translation></message>
    <message><source>limp until its first goal</source>
        <translation>relâché jusqu'à sa première cible</translation></message>
    <message><source>Starts: {0}</source>
        <translation>Démarrages : {0}</translation></message>
    <message><source>{0}: dead</source>
        <translation>{0} : en panne</translation></message>
    <message><source>{0}: blocked</source>
        <translation>{0} : bloqué</translation></message>
    <message><source>Reply byte</source>
        <translation>Octet de réponse</translation></message>
    <message><source>Command byte</source>
        <translation>Octet de commande</translation></message>
    <message><source>End of reply</source>
        <translation>Réponse : fin</translation></message>
    <message><source>holds</source>
        <translation>tient sa position</translation></message>
    <message><source>cannot reach {0}</source>
        <translation>ne peut pas atteindre {0}</translation></message>
    <message><source>moving to {0}</source>
        <translation>va vers {0}</translation></message>
    <message><source>This link has no stop command: a running motion ends by itself or when the servo power is cut.</source>
        <translation>Cette liaison n'a pas de commande d'arrêt : un mouvement en cours ne se termine que de lui-même, ou en coupant l'alimentation des servos.</translation></message>
    <message><source>End the sequence and send nothing more. A running motion continues to its goal. (Esc, anywhere)</source>
        <translation>Terminer la séquence, ne plus rien envoyer, laisser le robot où il est (Échap, partout)</translation></message>
    <message><source>End afte&amp;r this step</source>
        <translation>Ter&amp;miner après cette étape</translation></message>
    <message><source>&amp;Stop sequence</source>
        <translation>&amp;Arrêter la séquence</translation></message>
    <message><source>Let the step finish, then blend out</source>
        <translation>Finir l'étape, puis faire la transition de sortie</translation></message>
    <message><source>Plot of the motors' positions against time</source>
        <translation>Courbes des positions des moteurs en fonction du temps</translation></message>
    <message numerus="yes"><source>Aracna, firmware {0}, %n motor(s)</source>
        <translation><numerusform>Aracna, firmware {0}, %n moteur</numerusform><numerusform>Aracna, firmware {0}, %n moteurs</numerusform></translation></message>
    <message><source>Curve</source>
        <translation>Courbe</translation></message>
    <message><source>Present</source>
        <translation>Actuelle</translation></message>
    <message><source>Goal</source>
        <translation>Cible</translation></message>
    <message><source>Difference</source>
        <translation>Écart</translation></message>
    <message><source>Speed</source>
        <translation>Vitesse</translation></message>
    <message><source>Draw the position of this motor in the plot</source>
        <translation>Tracer la position de ce moteur dans le graphique</translation></message>
    <message><source>&amp;Save pose file</source>
        <translation>&amp;Enregistrer le fichier de poses</translation></message>
    <message><source>&amp;Open pose file…</source>
        <translation>&amp;Ouvrir un fichier de poses…</translation></message>
    <message><source>Not saved. {0}.</source>
        <translation>Non enregistré. {0}.</translation></message>
    <message><source>Pose files (*{0});;All files (*)</source>
        <translation>Fichiers de poses (*{0});;Tous les fichiers (*)</translation></message>
    <message><source>Not opened. {0}.</source>
        <translation>Non ouvert. {0}.</translation></message>
    <message><source>{0} was opened.</source>
        <translation>{0} a été ouvert.</translation></message>
    <message><source>Saved in {0}.</source>
        <translation>Enregistré dans {0}.</translation></message>
    <message><source>And {0} more.</source>
        <translation>Et encore {0}.</translation></message>
    <message><source>Sequences and gaits</source>
        <translation>Séquences et allures</translation></message>
    <message><source>New sequence</source>
        <translation>Nouvelle séquence</translation></message>
    <message><source>Select a sequence; built-in gaits cannot be changed</source>
        <translation>Choisissez une séquence ; les allures intégrées ne peuvent pas être modifiées</translation></message>
    <message><source>There are no poses</source>
        <translation>Il n'y a pas de poses</translation></message>
    <message><source>A step cannot use “{0}”: remove commas and vertical bars from the pose's name</source>
        <translation>Une étape ne peut pas utiliser « {0} » : enlevez les virgules et les barres verticales du nom de la pose</translation></message>
    <message><source>Steps</source>
        <translation>Étapes</translation></message>
    <message><source>Delete</source>
        <translation>Supprimer</translation></message>
    <message><source>Move up</source>
        <translation>Monter</translation></message>
    <message><source>Move down</source>
        <translation>Descendre</translation></message>
    <message><source>Select a sequence or a gait to see its steps.</source>
        <translation>Choisissez une séquence ou une allure pour voir ses étapes.</translation></message>
    <message><source>{0} ms</source>
        <translation>{0} ms</translation></message>
    <message><source>&amp;New</source>
        <translation>No&amp;uveau</translation></message>
    <message><source>Add s&amp;tep</source>
        <translation>Ajout&amp;er une étape</translation></message>
    <message><source>Add a step with the pose “{0}” after the current step</source>
        <translation>Ajouter une étape vers « {0} » après l'étape actuelle</translation></message>
    <message><source> ms</source>
        <translation> ms</translation></message>
    <message><source>Step</source>
        <translation>Étape</translation></message>
    <message><source>Pose</source>
        <translation>Pose</translation></message>
    <message><source>Time</source>
        <translation>Temps</translation></message>
    <message><source>Remarks</source>
        <translation>Remarques</translation></message>
    <message><source>No steps yet. “Add step” adds a step with the current pose.</source>
        <translation>Pas encore d'étapes. Ajoutez-en une : elle utilise la pose actuelle.</translation></message>
    <message><source>Milliseconds of step {0}</source>
        <translation>Millisecondes de l'étape {0}</translation></message>
    <message><source>Pose of step {0}</source>
        <translation>Pose de l'étape {0}</translation></message>
    <message><source>Uses the authors' poses, but was not made by them.</source>
        <translation>Utilise les poses des auteurs du robot, mais n'a pas été faite par eux.</translation></message>
    <message><source>Rename</source>
        <translation>Renommer</translation></message>
    <message><source>Duplicate</source>
        <translation>Dupliquer</translation></message>
    <message><source>&amp;Delete…</source>
        <translation>&amp;Supprimer…</translation></message>
    <message><source>{0} (built in)</source>
        <translation>{0} (intégrée)</translation></message>
    <message><source>Not renamed: {0}.</source>
        <translation>Non renommé : {0}.</translation></message>
    <message><source>Pos&amp;es</source>
        <translation>P&amp;oses</translation></message>
    <message><source>{0}, changed</source>
        <translation>{0}, modifié</translation></message>
    <message><source>needs {0:.2f} s (motor {1})</source>
        <translation>nécessite {0:.2f} s : moteur {1}</translation></message>
    <message numerus="yes"><source>%n step(s)</source>
        <translation><numerusform>%n étape</numerusform><numerusform>%n étapes</numerusform></translation></message>
    <message><source>{0:.1f} s</source>
        <translation>{0:.1f} s</translation></message>
    <message><source>Rounds</source>
        <translation>Cycles</translation></message>
    <message><source>Speed in percent</source>
        <translation>Vitesse en pour cent</translation></message>
    <message><source>&amp;Blend in</source>
        <translation>Tran&amp;sition d'entrée</translation></message>
    <message><source>B&amp;lend out to stand</source>
        <translation>Transition &amp;de sortie vers « stand »</translation></message>
    <message><source>Pla&amp;y</source>
        <translation>&amp;Jouer</translation></message>
    <message><source>Play the current sequence or gait.</source>
        <translation>Jouer la séquence ou l'allure actuelle.</translation></message>
    <message><source>{0}, {1} per round, {2} in total.</source>
        <translation>{0}, {1} par cycle, {2} au total.</translation></message>
    <message><source>0: repeat until stopped.</source>
        <translation>0 : répéter jusqu'à l'arrêt.</translation></message>
    <message><source> %</source>
        <translation> %</translation></message>
    <message><source>Changes during playback take effect from the next step. At 50 %, each step takes twice as long.</source>
        <translation>Aussi en cours de lecture, à partir de l'étape suivante. 50 % : chaque étape dure deux fois plus longtemps.</translation></message>
    <message><source>Move slowly to the start first, in 3 s.</source>
        <translation>Aller d'abord lentement, en 3 s, au départ.</translation></message>
    <message><source>At the end, move slowly to the pose “stand”, in 3 s.</source>
        <translation>À la fin, aller lentement, en 3 s, à la pose « stand ».</translation></message>
    <message><source>Select a sequence or a gait to play it.</source>
        <translation>Choisissez une séquence ou une allure pour la jouer.</translation></message>
    <message><source>Positions outside the limits are clamped.</source>
        <translation>Les positions hors limites sont ramenées aux limites.</translation></message>
    <message><source>Some motors are too slow.</source>
        <translation>Certains moteurs sont trop lents.</translation></message>
    <message><source>{0}, {1}.</source>
        <translation>{0}, {1}.</translation></message>
    <message><source>{0}, {1} per round, until stopped.</source>
        <translation>{0}, {1} par cycle, jusqu'à l'arrêt.</translation></message>
    <message><source>R&amp;ounds</source>
        <translation>C&amp;ycles</translation></message>
    <message><source>&amp;Speed</source>
        <translation>&amp;Vitesse</translation></message>
    <message><source>not defined</source>
        <translation>non définie</translation></message>
    <message><source>Cannot play: {0}.</source>
        <translation>Impossible de jouer : {0}.</translation></message>
    <message><source>The robot's position is unknown until its first move.</source>
        <translation>La position du robot est connue après son premier mouvement.</translation></message>
    <message><source>No poses. Capture the robot's position, or open a pose file.</source>
        <translation>Aucune pose. Capturez la position du robot, ou ouvrez un fichier de poses.</translation></message>
    <message><source>Set this pose to the robot's position</source>
        <translation>Donner à cette pose la position du robot</translation></message>
    <message><source>Capt&amp;ure</source>
        <translation>&amp;Capturer</translation></message>
    <message><source>&amp;Go to</source>
        <translation>Alle&amp;r à</translation></message>
    <message><source>Motor {0}: {1:.0f}°, limits {2} to {3}</source>
        <translation>Moteur {0} : {1:.0f}°, limites {2} à {3}</translation></message>
    <message><source>Save the robot's position as a new pose.</source>
        <translation>Enregistrer la position du robot comme nouvelle pose.</translation></message>
    <message><source>Move every motor to this pose, within its limits.</source>
        <translation>Amener tous les moteurs à cette pose, dans leurs limites.</translation></message>
    <message><source>Position of motor {0} in this pose</source>
        <translation>Position du moteur {0} dans cette pose</translation></message>
    <message><source>Motor {0}: {1:.0f}°, limits {2} to {3}, sent as {4}</source>
        <translation>Moteur {0} : {1:.0f}°, limites {2} à {3}, envoyé : {4}</translation></message>
    <message><source>Requests: {0}. Requests without a reply: {1}.</source>
        <translation>Requêtes : {0}, sans réponse : {1}.</translation></message>
    <message><source>Answered</source>
        <translation>Réponses</translation></message>
    <message><source>Slowest reply</source>
        <translation>Réponse la plus lente</translation></message>
    <message><source>Motions are not included</source>
        <translation>Hors mouvements</translation></message>
    <message><source>Restarts detected</source>
        <translation>Redémarrages</translation></message>
    <message><source>Corrupted replies</source>
        <translation>Réponses altérées</translation></message>
    <message><source>Unrecognized lines</source>
        <translation>Lignes non reconnues</translation></message>
    <message><source>{0}, active now</source>
        <translation>{0}, active</translation></message>
    <message><source>The robot from above</source>
        <translation>Le robot vu de dessus</translation></message>
    <message><source>Legs at their reported positions, goals dashed; the table shows both as numbers.</source>
        <translation>Pattes aux positions transmises, cibles en tirets ; le tableau donne les deux en chiffres.</translation></message>
    <message><source>front</source>
        <translation>avant</translation></message>
    <message><source>Present position unknown</source>
        <translation>Position actuelle inconnue</translation></message>
    <message><source>Speed setting 1–1023 in steps of 0.669 °/s; 0 means unlimited, not “stopped”. Above about 870 (AX-18A) or 530 (AX-12A) a servo gets no faster.</source>
        <translation>Réglage de vitesse 1-1023, 0,669 °/s par unité ; 0 signifie illimitée, et non « arrêté ». Au-delà d'environ 870 (AX-18A) ou 530 (AX-12A), un servo ne va pas plus vite.</translation></message>
    <message><source>goal in units</source>
        <translation>cible en unités</translation></message>
    <message><source>present position</source>
        <translation>position actuelle</translation></message>
    <message><source>lowest position</source>
        <translation>position la plus basse</translation></message>
    <message><source>highest position</source>
        <translation>position la plus haute</translation></message>
    <message><source>Present position {0}</source>
        <translation>Position actuelle {0}</translation></message>
    <message><source>goal in degrees</source>
        <translation>cible en degrés</translation></message>
    <message><source>state</source>
        <translation>état</translation></message>
    <message><source>speed</source>
        <translation>vitesse</translation></message>
    <message><source>goal</source>
        <translation>cible</translation></message>
    <message><source>last speed reported by the servo: {0}</source>
        <translation>le servo garde {0}</translation></message>
    <message><source>Leg*</source>
        <translation>Patte*</translation></message>
    <message><source>The order of the legs is assumed</source>
        <translation>L'attribution des pattes est supposée</translation></message>
    <message><source>Motor</source>
        <translation>Moteur</translation></message>
    <message><source>Handle: the goal. Wedge below: the last reported position.</source>
        <translation>Curseur : la cible. Repère triangulaire en dessous : la dernière position transmise.</translation></message>
    <message><source>Last reported position</source>
        <translation>Dernière position transmise</translation></message>
    <message><source>Present position minus goal</source>
        <translation>Position actuelle moins cible</translation></message>
    <message><source>Setting and degrees per second</source>
        <translation>Réglage et degrés par seconde</translation></message>
    <message><source>From</source>
        <translation>De</translation></message>
    <message><source>To</source>
        <translation>À</translation></message>
    <message><source>The positions of the motors are unknown.</source>
        <translation>Les positions des moteurs sont inconnues.</translation></message>
    <message><source>This robot reports positions only in its reply to a move.</source>
        <translation>Ce robot ne les transmet que dans sa réponse à un mouvement.</translation></message>
    <message><source>The first move runs at speed {0} ({1}) unless you set other speeds.</source>
        <translation>Le premier se fait à la vitesse {0} ({1}), sauf si vous choisissez d'autres vitesses.</translation></message>
    <message><source>Move every motor to its goal, within its limits (Ctrl+M)</source>
        <translation>Amener tous les moteurs à leur cible, dans leurs limites (Ctrl+M)</translation></message>
    <message><source>The last motion may still be running; the next move will report the positions.</source>
        <translation>Le dernier mouvement est peut-être encore en cours ; le prochain les transmettra.</translation></message>
    <message><source>Pre&amp;sent</source>
        <translation>Act&amp;uelle</translation></message>
    <message><source>Present positions</source>
        <translation>Positions actuelles</translation></message>
    <message><source>Ce&amp;ntre</source>
        <translation>&amp;Centre</translation></message>
    <message><source>512 = 150°; nothing moves yet</source>
        <translation>512 = 150° ; rien ne bouge encore</translation></message>
    <message><source>S&amp;tand</source>
        <translation>De&amp;bout</translation></message>
    <message><source>Inner 512, outer 550; nothing moves yet</source>
        <translation>Intérieures 512, extérieures 550 ; rien ne bouge encore</translation></message>
    <message><source>Speed of all motors</source>
        <translation>Vitesse de tous les moteurs</translation></message>
    <message><source>Mo&amp;ve</source>
        <translation>&amp;Déplacer</translation></message>
    <message><source>Send while dra&amp;gging</source>
        <translation>Envoyer pendant le &amp;glissement</translation></message>
    <message><source>Reset li&amp;mits</source>
        <translation>&amp;Réinitialiser les limites</translation></message>
    <message><source>Inner 50–600, outer 0–550: tuned on the robot by its authors</source>
        <translation>Intérieures 50–600, extérieures 0–550 : ajustées sur le robot par ses auteurs</translation></message>
    <message><source>&amp;Limits instead of speeds</source>
        <translation>Limites au lieu des vit&amp;esses</translation></message>
    <message><source>Speed &amp;of all:</source>
        <translation>&amp;Vitesse de tous :</translation></message>
    <message><source>Goals and limits can already be set.</source>
        <translation>Les cibles et les limites peuvent déjà être réglées.</translation></message>
    <message><source>Every motor has reached its goal within a few units.</source>
        <translation>Tous les moteurs ont atteint leur cible à quelques unités près.</translation></message>
    <message><source>The newest goal is sent as soon as the robot has reached the previous goal</source>
        <translation>La cible la plus récente est envoyée dès que le robot a atteint la précédente</translation></message>
    <message><source>Range of each joint. Goals outside this range are clamped before they are sent.</source>
        <translation>Jusqu'où chaque articulation peut tourner ; les cibles sont ramenées aux limites avant l'envoi</translation></message>
    <message><source>differ</source>
        <translation>différentes</translation></message>
    <message><source>Set sliders to:</source>
        <translation>Position des curseurs :</translation></message>
    <message><source>Pages</source>
        <translation>Pages</translation></message>
    <message><source>a robot</source>
        <translation>un robot</translation></message>
    <message><source>Demo Aracna</source>
        <translation>Démo Aracna</translation></message>
    <message><source>an Aracna pose file</source>
        <translation>un fichier de poses d'un Aracna</translation></message>
    <message><source>&amp;Aracna</source>
        <translation>&amp;Aracna</translation></message>
    <message><source>Stop &amp;recording</source>
        <translation>Arrêter l'enregist&amp;rement</translation></message>
    <message><source>&amp;Record…</source>
        <translation>Démarrer l'enregist&amp;rement…</translation></message>
    <message><source>Nothing can be recorded: no robot is connected.</source>
        <translation>Rien ne peut être enregistré : aucun robot n'est connecté.</translation></message>
    <message><source>Aracna, Open recording</source>
        <translation>Aracna, Ouvrir un enregistrement</translation></message>
    <message><source>Keep clear of the legs: this robot has no stop command. Nothing moves until you press Move.</source>
        <translation>Laissez de la place aux pattes : ce robot n'a pas d'arrêt. Rien ne bouge tant que vous ne choisissez pas Déplacer.</translation></message>
    <message><source>No robot at hand?</source>
        <translation>Pas de robot sous la main ?</translation></message>
    <message><source>Tr&amp;y the demo</source>
        <translation>&amp;Essayer la démo</translation></message>
    <message><source>R&amp;obot</source>
        <translation>&amp;Robot</translation></message>
    <message><source>&amp;Move to the sliders' goals</source>
        <translation>&amp;Déplacer vers les cibles des curseurs</translation></message>
    <message><source>Pla&amp;y the current sequence or gait</source>
        <translation>&amp;Jouer la séquence ou l'allure actuelle</translation></message>
    <message><source>&amp;End sequence after this step</source>
        <translation>&amp;Terminer la séquence après cette étape</translation></message>
    <message><source>Ope&amp;n recording…</source>
        <translation>Ou&amp;vrir un enregistrement…</translation></message>
    <message><source>Set up &amp;goals and limits without a robot</source>
        <translation>Régler cibles et limites &amp;sans robot</translation></message>
    <message><source>&amp;Debug LED of the board</source>
        <translation>&amp;LED de débogage de la carte</translation></message>
    <message><source>&amp;New pose file</source>
        <translation>&amp;Nouveau fichier de poses</translation></message>
    <message><source>Save pose file &amp;as…</source>
        <translation>Enregistrer le fichier de poses &amp;sous…</translation></message>
    <message><source>&amp;Undo</source>
        <translation>&amp;Annuler</translation></message>
    <message><source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation></message>
    <message><source>&amp;Capture the present position as a pose</source>
        <translation>&amp;Capturer la position actuelle comme pose</translation></message>
    <message><source>&amp;Demo Aracna panel</source>
        <translation>Panneau &amp;Démo Aracna</translation></message>
    <message><source>Connect my {0}</source>
        <translation>Connecter mon {0}</translation></message>
    <message><source>Connect an FTDI cable to the header or plug an XBee radio into the socket: both share one line. Switch on the servo power as well. Without servo power, the first move never ends.</source>
        <translation>Un câble FTDI sur le connecteur, ou une radio XBee dans le support : tous deux partagent une ligne. Mettez aussi l'alimentation des servos sous tension, sans laquelle le premier mouvement ne se termine jamais.</translation></message>
    <message><source>Open pose fi&amp;le…</source>
        <translation>O&amp;uvrir un fichier de poses…</translation></message>
    <message><source>Set &amp;up goals and limits</source>
        <translation>&amp;Régler cibles et limites</translation></message>
    <message><source>ArbotiX</source>
        <translation>ArbotiX</translation></message>
    <message><source>Adapter</source>
        <translation>Adaptateur</translation></message>
    <message><source>bench tests</source>
        <translation>essais au banc</translation></message>
    <message><source>line {0}: expected the columns {1}</source>
        <translation>ligne {0} : colonnes attendues : {1}</translation></message>
    <message><source>it is not a text file</source>
        <translation>ce n'est pas un fichier texte</translation></message>
    <message><source>line {0}: invalid row “{1}”</source>
        <translation>ligne {0} : ligne non valide « {1} »</translation></message>
    <message><source>line 1: a bench test begins with {0!r}</source>
        <translation>ligne 1 : un essai au banc commence par {0!r}</translation></message>
    <message><source>motor: expected 1 or 2, not {0}</source>
        <translation>moteur : 1 ou 2 attendu, pas {0}</translation></message>
    <message><source>the line “# {0}: …” is missing</source>
        <translation>la ligne « # {0}: … » manque</translation></message>
    <message><source>line {0}: expected a name and a value</source>
        <translation>ligne {0} : un nom et une valeur sont attendus</translation></message>
    <message><source>{0}: invalid value “{1}”</source>
        <translation>{0} : valeur non valide « {1} »</translation></message>
    <message><source>line {0} or below: {1}</source>
        <translation>ligne {0} ou plus bas : {1}</translation></message>
    <message><source>step {0}, {1} s</source>
        <translation>échelon {0}, {1} s</translation></message>
    <message><source>ramp {0}, {1} s</source>
        <translation>rampe {0}, {1} s</translation></message>
    <message><source>reverse {0}, {1} s</source>
        <translation>inversion {0}, {1} s</translation></message>
    <message><source>sine {0}, {1} s</source>
        <translation>sinus {0}, {1} s</translation></message>
    <message><source>the speed of a bench test must be −{0} to −1 or 1 to {0}, not {1}</source>
        <translation>la vitesse d'un essai au banc va de −{0} à {0} sans être 0, pas {1}</translation></message>
    <message><source>a bench test must last {0:g} to {1:g} s, not {2:g} s</source>
        <translation>un essai au banc dure de {0:g} à {1:g} s, pas {2:g} s</translation></message>
    <message><source>the period of a bench test must be {0:g} to {1:g} s, not {2:g} s</source>
        <translation>la période d'un essai au banc va de {0:g} à {1:g} s, pas {2:g} s</translation></message>
    <message><source>{0} Doubtful: the line is noisy and has no CRC.</source>
        <translation>{0} Douteux : la liaison est bruitée et n'a pas de CRC.</translation></message>
    <message><source>The board does not respond; the stop is being repeated.</source>
        <translation>La carte ne répond pas ; l'ordre d'arrêt est répété.</translation></message>
    <message><source>Check the cable and the ground connection, and make sure that no other program sends on this line.</source>
        <translation>Vérifiez le câble et la masse, et qu'aucun autre programme n'émet sur cette liaison.</translation></message>
    <message><source>Check the cable and the ground connection, and make sure that every program on this line uses the same polynomial.</source>
        <translation>Vérifiez le câble et la masse, et que tous les programmes sur cette liaison utilisent le même polynôme.</translation></message>
    <message><source>Check the cable, the ground connection and the baud rate, and keep motor leads away from the cable.</source>
        <translation>Vérifiez le câble, la masse et le débit, et éloignez les fils des moteurs de la liaison.</translation></message>
    <message><source>Use a lower baud rate.</source>
        <translation>Utilisez un débit plus bas.</translation></message>
    <message><source>Check the cable and the ground connection, and make sure that every program on this line uses the same parity.</source>
        <translation>Vérifiez le câble et la masse, et que tous les programmes sur cette liaison utilisent la même parité.</translation></message>
    <message><source>Make sure that no other program sends on this line.</source>
        <translation>Ne laissez aucun autre programme émettre sur cette liaison.</translation></message>
    <message><source>Make other programs request fewer channels at once.</source>
        <translation>Faites en sorte que les autres programmes demandent moins de voies à la fois.</translation></message>
    <message><source>Latched before connecting, perhaps by a search for the board: {0}</source>
        <translation>Mémorisé avant la connexion, peut-être à cause de la recherche de la carte : {0}</translation></message>
    <message><source>Connected to {0} on {1}.</source>
        <translation>Connecté à {0} sur {1}.</translation></message>
    <message><source>The board responds again</source>
        <translation>La carte répond de nouveau</translation></message>
    <message><source>The board was switched off and on</source>
        <translation>L'alimentation de la carte a été coupée et remise</translation></message>
    <message><source>A setting changed: the board was restarted, or another program wrote to it</source>
        <translation>Un réglage a changé : la carte a été redémarrée, ou un autre programme y a écrit</translation></message>
    <message><source>Device {0} selected: {1}</source>
        <translation>Appareil {0} sélectionné : {1}</translation></message>
    <message><source>{0} (doubtful)</source>
        <translation>{0} (douteux)</translation></message>
    <message><source>The notes, calibrations and applied settings saved for this {0} date from {1}, when it was connected through another USB adapter or socket. If this is another board, give it its own device number: boards with the same number share these files.</source>
        <translation>Ce qui est conservé ici pour ce {0} (notes, étalonnages, réglages appliqués) date de {1}, quand il était sur un autre adaptateur USB ou une autre prise. S'il s'agit d'une autre carte, donnez-lui son propre numéro d'appareil : les cartes de même numéro partagent ce qui est conservé.</translation></message>
    <message><source>Disconnected</source>
        <translation>Déconnecté</translation></message>
    <message><source>The board received nothing within its Serial Timeout, so the motors were stopped.</source>
        <translation>La carte n'a rien reçu pendant son « Délai série » ; les moteurs ont donc été arrêtés.</translation></message>
    <message><source>The board stopped its motors because of an error on the line ({0}): UART-Error Shutdown is set.</source>
        <translation>La carte a arrêté ses moteurs à cause d'une erreur sur la liaison ({0}) : « Arrêt sur erreur UART » est activé.</translation></message>
    <message><source>The board stopped responding.</source>
        <translation>La carte a cessé de répondre.</translation></message>
    <message><source>Bytes were corrupted: motor commands are repeated until the line is quiet</source>
        <translation>Des octets ont été altérés : les commandes des moteurs sont répétées jusqu'à ce que la ligne soit calme</translation></message>
    <message><source>this program</source>
        <translation>ce programme</translation></message>
    <message><source>Motors may still be turning: disconnected before a stop was confirmed</source>
        <translation>Déconnecté avant la confirmation d'un arrêt : les moteurs peuvent encore tourner</translation></message>
    <message><source>The server of the robot does not respond.</source>
        <translation>Le réseau vers le robot est muet.</translation></message>
    <message><source>Driver: {0}</source>
        <translation>Pilote : {0}</translation></message>
    <message><source>The line is noisy: {0:.1f} % of the replies were lost or corrupted</source>
        <translation>La liaison est bruitée : {0:.1f} % de pertes</translation></message>
    <message><source>The line is good again</source>
        <translation>La liaison est de nouveau bonne</translation></message>
    <message><source>The board reports: {0}.</source>
        <translation>La carte signale : {0}.</translation></message>
    <message><source>noisy: {0:.1f} % of the requests in the last {1:.0f} s were answered</source>
        <translation>bruitée : {0:.1f} % des requêtes des {1:.0f} dernières secondes ont reçu une réponse</translation></message>
    <message><source>being measured …</source>
        <translation>mesure en cours …</translation></message>
    <message><source>good: {0:.1f} % of the requests in the last {1:.0f} s were answered</source>
        <translation>bonne : {0:.1f} % des requêtes des {1:.0f} dernières secondes ont reçu une réponse</translation></message>
    <message><source>The proposed ends lie inside the measured ends by 1 % of the travel plus three times the noise, so that full output is reliably reached. The deadband covers the noise at rest, but is at least {0}, because a stick does not return to exactly the same position each time.</source>
        <translation>Les extrémités sont placées à l'intérieur de celles mesurées, de 1 % de la course et de trois fois le bruit, afin que la sortie maximale soit atteinte à coup sûr. La zone morte couvre le bruit au repos, mais vaut au moins {0}, car un manche ne revient pas chaque fois exactement au même endroit.</translation></message>
    <message><source>At rest the noise is {0}, so the deadband is twice this value.</source>
        <translation>Au repos, son bruit est de {0} : la zone morte vaut le double.</translation></message>
    <message><source>{0}, so the channel should be reversed.</source>
        <translation>{0} ; réglage conseillé : inversée.</translation></message>
    <message><source>{0}, so the channel should not be reversed.</source>
        <translation>{0} ; réglage conseillé : non inversée.</translation></message>
    <message><source>The measured ends are up to {0} beyond the proposed ends.</source>
        <translation>Les extrémités mesurées sont jusqu'à {0} plus loin.</translation></message>
    <message><source>The signal never goes above its rest position, so maximum is set to the limit of the input.</source>
        <translation>Elle ne va jamais au-dessus de sa position de repos ; le maximum est donc réglé à la limite de l'entrée.</translation></message>
    <message><source>The signal never goes below its rest position, so minimum is set to the limit of the input.</source>
        <translation>Elle ne va jamais en dessous de sa position de repos ; le minimum est donc réglé à la limite de l'entrée.</translation></message>
    <message><source>The value fell when the stick first went forward or right</source>
        <translation>La valeur a diminué quand le manche est d'abord allé vers l'avant ou vers la droite</translation></message>
    <message><source>The value rose when the stick first went forward or right</source>
        <translation>La valeur a augmenté quand le manche est d'abord allé vers l'avant ou vers la droite</translation></message>
    <message><source>The value is higher in the other position than at rest, where the switch should be off</source>
        <translation>L'autre position est au-dessus de celle de repos, qui devrait être inactive</translation></message>
    <message><source>The value is lower in the other position than at rest, where the switch should be off</source>
        <translation>L'autre position est en dessous de celle de repos, qui devrait être inactive</translation></message>
    <message><source>there is nothing to compare: only probes were sent</source>
        <translation>il n'y a rien à comparer : rien n'a été envoyé, sauf pour rechercher</translation></message>
    <message><source>TReX 1.2, because no signature was read</source>
        <translation>TReX 1.2, car aucune signature n'a été lue</translation></message>
    <message><source>1 stored value</source>
        <translation>1 valeur enregistrée</translation></message>
    <message><source>{0}, {1} from the file, all other values at their defaults</source>
        <translation>{0}, {1} du fichier, le reste comme en sortie d'usine</translation></message>
    <message><source>traffic logs</source>
        <translation>journaux de trafic</translation></message>
    <message><source>{0} stored values</source>
        <translation>{0} valeurs enregistrées</translation></message>
    <message><source>{0}; the simulated board uses the default value instead.</source>
        <translation>{0} ; la carte simulée a sa valeur par défaut.</translation></message>
    <message><source>learned channels</source>
        <translation>voies apprises</translation></message>
    <message><source>done</source>
        <translation>terminé</translation></message>
    <message><source>calibration of channel {0}</source>
        <translation>étalonnage de la voie {0}</translation></message>
    <message><source>Calibration of channel {0}</source>
        <translation>Étalonnage de la voie {0}</translation></message>
    <message><source>stored settings</source>
        <translation>réglages enregistrés</translation></message>
    <message><source>device number {0}</source>
        <translation>numéro d'appareil {0}</translation></message>
    <message><source>Only the full search finds a board with a custom CRC polynomial.</source>
        <translation>Une carte dont le polynôme CRC est personnalisé n'est trouvée que par la recherche complète.</translation></message>
    <message><source> It also echoes what is sent.</source>
        <translation> Il renvoie aussi l'écho de ce qui est envoyé.</translation></message>
    <message><source>After a power cycle, it will run at {0}.</source>
        <translation>Une fois l'alimentation coupée et remise, elle fonctionnera à {0}.</translation></message>
    <message><source>No TReX responds on {0} at any baud rate, with any parity or with CRC. Check that the board has power (an LED is lit), that the adapter's TX goes to SI and its RX to SO (an RS-232 adapter: to the RS-232 pins), and that ground is connected.</source>
        <translation>Aucun TReX ne répond sur {0}, quels que soient le débit et la parité, ni avec CRC. Vérifiez que la carte est alimentée (une LED est allumée), que TX de l'adaptateur va à SI et son RX à SO (ou aux deux broches RS-232, sans jamais mélanger), et que la masse est reliée.</translation></message>
    <message><source>Something is connected to {0}, but it does not respond like a TReX: it sent {1} at {2}{3}. Either it is another device, or the line is noisy.</source>
        <translation>Quelque chose est connecté à {0}, mais ne répond pas comme un TReX : il a envoyé {1} à {2}{3}. C'est un autre appareil, ou la liaison est bruitée.</translation></message>
    <message><source>It is set to {0} baud, but with this setting, firmware {1} runs at half the rate: connect at {2} baud.</source>
        <translation>Elle est réglée sur {0} bauds, que le firmware {1} fait fonctionner à la moitié : connectez à {2}.</translation></message>
    <message><source>It is set to {0} stop bits; either number works on this line.</source>
        <translation>Elle est réglée sur {0} bits d'arrêt ; les deux nombres fonctionnent sur cette liaison.</translation></message>
    <message><source> The port does not support {0} baud, so the scan skipped these settings.</source>
        <translation> Le port n'accepte pas {0} bauds ; ces réglages n'ont donc pas été essayés.</translation></message>
    <message><source>, and data at {0} other settings</source>
        <translation>, et quelque chose à {0} autres réglages</translation></message>
    <message><source>Its UART settings have the unknown value {0:#04x}.</source>
        <translation>Ses réglages UART contiennent {0:#04x}, qui n'est pas un réglage connu.</translation></message>
    <message><source>No TReX responds on {0}: at every rate, everything sent comes back and nothing else arrives. Either this is the RS-232 side of a board that is off, or the adapter's TX and RX are joined.</source>
        <translation>Aucun TReX ne répond sur {0} : tout ce qui est envoyé revient, et rien d'autre, à tous les débits. Soit c'est le côté RS-232 d'une carte hors tension, soit TX et RX de l'adaptateur sont reliés.</translation></message>
    <message><source>No TReX responds on {0}. The baud rate is set at the other end of the network, so only that rate could be tried, without parity and without CRC.</source>
        <translation>Aucun TReX ne répond sur {0}. Le débit est réglé à l'autre bout du réseau ; seul celui-ci a donc pu être essayé, sans parité et sans CRC.</translation></message>
    <message><source>The connection was lost: motors may still be turning.</source>
        <translation>La connexion est perdue : les moteurs tournent peut-être encore.</translation></message>
    <message><source>Cut the power.</source>
        <translation>Coupez l'alimentation.</translation></message>
    <message><source>The board does not respond.</source>
        <translation>La carte ne répond pas.</translation></message>
    <message><source>The server stops the motors half a second after the last heartbeat.</source>
        <translation>Son serveur arrête les moteurs une demi-seconde après le dernier signe de vie.</translation></message>
    <message><source>Channel {0} is required but has no signal.</source>
        <translation>La voie {0} est requise, mais n'a pas de signal.</translation></message>
    <message><source>Safe-start keeps the motors off: switch the transmitter on and release its sticks.</source>
        <translation>Le démarrage sécurisé maintient les moteurs à l'arrêt : allumez l'émetteur et relâchez ses manches.</translation></message>
    <message><source>Channel {0} is {1} above neutral.</source>
        <translation>La voie {0} est à {1} au-dessus du neutre.</translation></message>
    <message><source>Safe-start holds the motors until the channel is within about {2} of neutral (inferred): release the stick, or calibrate the channel (in serial mode).</source>
        <translation>Le démarrage sécurisé bloque les moteurs jusqu'à ce que l'écart soit d'au plus {2} environ (déduit) : relâchez le manche, ou étalonnez la voie (en mode série).</translation></message>
    <message><source>Channel {0} is {1} below neutral.</source>
        <translation>La voie {0} est à {1} en dessous du neutre.</translation></message>
    <message><source>Channel 5 requests serial override.</source>
        <translation>La voie 5 demande la priorité série.</translation></message>
    <message><source>Safe-start holds the motors until you turn the switch of channel 5 off.</source>
        <translation>Le démarrage sécurisé bloque les moteurs tant que cet interrupteur n'a pas été inactif une fois.</translation></message>
    <message><source>Safe-start may be holding the motors (inferred).</source>
        <translation>Le démarrage sécurisé bloque peut-être les moteurs (déduit).</translation></message>
    <message><source>Release all sticks.</source>
        <translation>Relâchez tous les manches.</translation></message>
    <message><source>Motor {0} is off: its driver shut down because of overheating, a short circuit or low voltage.</source>
        <translation>Le moteur {0} n'est plus alimenté : son driver s'est coupé (surchauffe, court-circuit ou tension trop basse).</translation></message>
    <message><source>Reduce the load, check the wires and the battery, and let the driver cool.</source>
        <translation>Réduisez la charge, vérifiez les fils et la batterie, laissez-le refroidir.</translation></message>
    <message><source>Serial timeout: the board received nothing for {0}.</source>
        <translation>Délai série dépassé : la carte n'a rien reçu pendant {0}.</translation></message>
    <message><source>Check the cable, or set a longer Serial Timeout in Parameters.</source>
        <translation>Vérifiez le câble, ou réglez un « Délai série » plus long dans Paramètres.</translation></message>
    <message><source>Serial errors ({0}): the board stops the motors when bytes arrive corrupted.</source>
        <translation>Erreurs série ({0}) : la carte arrête les moteurs quand des octets arrivent altérés.</translation></message>
    <message><source>Check the cable and the ground connection. Without UART-Error Shutdown, the Serial Timeout may not stop the motors either (twin).</source>
        <translation>Vérifiez le câble et la masse. Sans « Arrêt sur erreur UART », le « Délai série » n'arrête peut-être pas non plus les moteurs (jumeau).</translation></message>
    <message><source>Stopping: the board has not confirmed the stop yet.</source>
        <translation>Arrêt en cours : la carte ne l'a pas encore confirmé.</translation></message>
    <message><source>The stop is being repeated. Motors may still be turning.</source>
        <translation>L'ordre d'arrêt est répété ; les moteurs peuvent encore tourner.</translation></message>
    <message><source>Stopped. The motors are locked for {0} s.</source>
        <translation>Arrêt effectué. Les moteurs sont verrouillés pendant {0} s.</translation></message>
    <message><source>Then arm them again.</source>
        <translation>Réactivez-les ensuite.</translation></message>
    <message><source>{0} drives this robot. You can watch and stop it.</source>
        <translation>{0} pilote ce robot. Vous pouvez l'observer et l'arrêter.</translation></message>
    <message><source>“Arm motors” asks {0} to hand over control.</source>
        <translation>« Activer les moteurs » demande à {0} de le céder.</translation></message>
    <message><source>No board is connected.</source>
        <translation>Aucune carte n'est connectée.</translation></message>
    <message><source>Select a port above and press Connect.</source>
        <translation>Choisissez un port ci-dessus et cliquez sur « Connecter ».</translation></message>
    <message><source>The program is connecting to the board.</source>
        <translation>Le programme se connecte à la carte.</translation></message>
    <message><source>The connection is being closed.</source>
        <translation>La connexion est en cours de fermeture.</translation></message>
    <message><source>The board has not yet reported what controls the motors.</source>
        <translation>La carte n'a pas encore indiqué ce qui commande les moteurs.</translation></message>
    <message><source>The board reports that serial commands do not control the motors.</source>
        <translation>La carte indique que les commandes série ne commandent pas les moteurs.</translation></message>
    <message><source>Switch the board off and on.</source>
        <translation>Il faut couper et remettre l'alimentation de la carte.</translation></message>
    <message><source>The RC channels control the motors, not serial commands.</source>
        <translation>Les voies RC commandent les moteurs, et non les commandes série.</translation></message>
    <message><source>To drive by serial commands, turn on the override switch (channel 5), or switch the board off, remove the mode jumper and switch the board on again.</source>
        <translation>Pour piloter par commandes série, activez l'interrupteur de priorité (voie 5), ou coupez l'alimentation de la carte, retirez le cavalier de mode et remettez l'alimentation.</translation></message>
    <message><source>The analog channels control the motors, not serial commands.</source>
        <translation>Les voies analogiques commandent les moteurs, et non les commandes série.</translation></message>
    <message><source>Commands without a device number would reach several boards.</source>
        <translation>Des commandes sans numéro d'appareil atteindraient plusieurs cartes.</translation></message>
    <message><source>Select one of the boards on this line.</source>
        <translation>Sélectionnez l'une des cartes de cette liaison.</translation></message>
    <message><source>Board {0}, which is driven together with this board, does not follow commands.</source>
        <translation>La carte {0}, conduite avec celle-ci, ne suit pas.</translation></message>
    <message><source>Its diagram shows why. “Drive alone” drives the other board without it.</source>
        <translation>Son dessin dit pourquoi. « Conduire seule » utilise l'autre sans elle.</translation></message>
    <message><source>The motors cannot be armed at this moment.</source>
        <translation>Les moteurs ne peuvent pas être activés pour le moment.</translation></message>
    <message><source>Stopped. {0}</source>
        <translation>Arrêt effectué. {0}</translation></message>
    <message><source>Arm the motors again to continue.</source>
        <translation>Réactivez-les pour continuer.</translation></message>
    <message><source>Not armed: no motor is driven.</source>
        <translation>Moteurs non activés : rien n'est encore envoyé.</translation></message>
    <message><source>Put the robot on blocks, then arm the motors.</source>
        <translation>Posez le robot sur cales, puis activez les moteurs.</translation></message>
    <message><source>Motor {0} is slowed down: its current exceeds the limit.</source>
        <translation>Le moteur {0} est ralenti : courant au-dessus de la limite.</translation></message>
    <message><source>Reduce the load, or raise the current limit in Parameters.</source>
        <translation>Réduisez la charge, ou augmentez la limite de courant dans Paramètres.</translation></message>
    <message><source>The motors are armed: the controls on the Motors page move them.</source>
        <translation>Les moteurs sont activés : les commandes de la page Moteurs les font tourner.</translation></message>
    <message><source>Esc stops everything.</source>
        <translation>Échap arrête tout.</translation></message>
    <message><source>Channel 5 overrides the sticks for as long as its switch is on.</source>
        <translation>La voie 5 a priorité sur les manches tant que son interrupteur est actif.</translation></message>
    <message><source>Joint mode: both drivers work as one motor.</source>
        <translation>Mode jumelé : les deux drivers fonctionnent comme un seul moteur.</translation></message>
    <message><source>If the green LED is steady instead, safe-start is over.</source>
        <translation>Si la LED verte est fixe, le démarrage sécurisé est terminé.</translation></message>
    <message><source>on</source><comment>LED</comment>
        <translation>allumée</translation></message>
    <message><source>off</source><comment>LED</comment>
        <translation>éteinte</translation></message>
    <message><source>flickers with each packet</source><comment>LED</comment>
        <translation>scintille à chaque paquet</translation></message>
    <message><source>flashes fast</source><comment>LED</comment>
        <translation>clignote vite</translation></message>
    <message><source>Motors may still be turning.</source>
        <translation>Les moteurs tournent peut-être encore.</translation></message>
    <message><source>The board should stop its motors {0} after the last byte. If it does not, cut the power.</source>
        <translation>La carte devrait arrêter les moteurs {0} après le dernier octet ; sinon, coupez l'alimentation.</translation></message>
    <message><source>The auxiliary motor may still be turning.</source>
        <translation>Le moteur auxiliaire tourne peut-être encore.</translation></message>
    <message><source>Motor {0} may still be turning.</source>
        <translation>Le moteur {0} tourne peut-être encore.</translation></message>
    <message><source>Not written: the settings stored in the board have changed since the review.</source>
        <translation>Non écrit : la carte contient d'autres réglages que lors de la vérification.</translation></message>
    <message><source>The same settings for several boards</source>
        <translation>Les mêmes réglages pour plusieurs cartes</translation></message>
    <message><source>The board does not respond. Check that it has power.</source>
        <translation>Elle ne répond pas. Vérifiez qu'elle est alimentée.</translation></message>
    <message><source>Not verified: {0}. {1}</source>
        <translation>Non vérifié : {0}. {1}</translation></message>
    <message><source>The connection was closed.</source>
        <translation>La connexion a été fermée.</translation></message>
    <message><source>In joint mode the board measures no current, so excessive current could not abort a test.</source>
        <translation>En mode jumelé, la carte ne mesure pas de courant : un essai ne pourrait pas être interrompu.</translation></message>
    <message><source>No current has been read yet.</source>
        <translation>Aucun courant n'a encore été lu.</translation></message>
    <message><source>Serial commands no longer reach the motors.</source>
        <translation>Les commandes série n'atteignent plus les moteurs.</translation></message>
    <message><source>Stop was pressed.</source>
        <translation>L'arrêt a été demandé.</translation></message>
    <message><source>Bench test of motor {0}: {1}</source>
        <translation>Essai au banc du moteur {0} : {1}</translation></message>
    <message><source>Motor {0} drew {1:.2f} A, more than the abort current of {2:g} A.</source>
        <translation>Le moteur {0} a consommé {1:.2f} A, plus que le courant d'interruption de {2:g} A.</translation></message>
    <message><source>The board received nothing within its Serial Timeout.</source>
        <translation>La carte n'a rien reçu pendant son « Délai série ».</translation></message>
    <message><source>The driver of motor {0} reported a fault.</source>
        <translation>Le driver du moteur {0} a signalé un défaut.</translation></message>
    <message><source>No current was read for {0:g} s.</source>
        <translation>Aucun courant n'a été lu pendant {0:g} s.</translation></message>
    <message><source>Motor {0} exceeded its current limit.</source>
        <translation>Le moteur {0} a dépassé sa limite de courant.</translation></message>
    <message><source>No other board replies on this line. Every board needs power, the same serial settings as the connected board, and a unique device number.</source>
        <translation>Aucune autre carte ne répond sur cette liaison. Chacune doit être alimentée, avoir les réglages série de celle-ci et un numéro d'appareil qui lui est propre.</translation></message>
    <message numerus="yes"><source>%n board(s) on this line.</source>
        <translation><numerusform>%n carte sur cette liaison.</numerusform><numerusform>%n cartes sur cette liaison.</numerusform></translation></message>
    <message><source>Another board was selected.</source>
        <translation>Une autre carte a été sélectionnée.</translation></message>
    <message><source>Minimum cannot pass neutral.</source>
        <translation>Le minimum ne peut pas dépasser le neutre.</translation></message>
    <message><source>Maximum cannot pass neutral.</source>
        <translation>Le maximum ne peut pas passer sous le neutre.</translation></message>
    <message><source>The deadband cannot be wider than the travel.</source>
        <translation>La zone morte ne peut pas être plus large que la course.</translation></message>
    <message><source>Minimum and maximum must differ.</source>
        <translation>Le minimum et le maximum doivent être différents.</translation></message>
    <message><source>Neutral cannot pass minimum.</source>
        <translation>Le neutre ne peut pas passer sous le minimum.</translation></message>
    <message><source>Neutral cannot pass maximum.</source>
        <translation>Le neutre ne peut pas dépasser le maximum.</translation></message>
    <message><source>The ends of the deadband cannot pass neutral.</source>
        <translation>La zone morte s'arrête au neutre.</translation></message>
    <message><source>Motor 1</source>
        <translation>Moteur 1</translation></message>
    <message><source>Motor 2</source>
        <translation>Moteur 2</translation></message>
    <message><source>Auxiliary</source>
        <translation>Auxiliaire</translation></message>
    <message><source>Flip</source>
        <translation>Retournement</translation></message>
    <message><source>Override</source>
        <translation>Priorité</translation></message>
    <message><source>RC pulses</source>
        <translation>Impulsions RC</translation></message>
    <message><source>analog voltages</source>
        <translation>tensions analogiques</translation></message>
    <message><source>drives motor 1, or steers when the mix jumper is on</source>
        <translation>commande le moteur 1 ; avec le cavalier Mix, elle commande la direction</translation></message>
    <message><source>drives motor 2, or drives forward and back when the mix jumper is on</source>
        <translation>commande le moteur 2 ; avec le cavalier Mix, elle commande la marche avant et arrière</translation></message>
    <message><source>drives the auxiliary motor, which turns one way only</source>
        <translation>commande le moteur auxiliaire, qui ne tourne que dans un sens</translation></message>
    <message><source>is the flip switch: motors 1 and 2 are swapped and reversed</source>
        <translation>est l'interrupteur de retournement : les moteurs 1 et 2 échangent leurs places et leurs sens</translation></message>
    <message><source>is the override switch: serial commands control the motors</source>
        <translation>est l'interrupteur de priorité : les commandes série commandent les moteurs</translation></message>
    <message><source>drives motor 1 (the mix jumper is off)</source>
        <translation>commande le moteur 1 (sans le cavalier Mix)</translation></message>
    <message><source>steers with both motors (the mix jumper is on)</source>
        <translation>commande la direction : elle agit sur les deux moteurs (avec le cavalier Mix)</translation></message>
    <message><source>drives motor 2 (the mix jumper is off)</source>
        <translation>commande le moteur 2 (sans le cavalier Mix)</translation></message>
    <message><source>drives both motors forward and back (the mix jumper is on)</source>
        <translation>commande les deux moteurs en marche avant et arrière (avec le cavalier Mix)</translation></message>
    <message><source>drives the single motor that both drivers power (joint mode, no mixing)</source>
        <translation>commande le seul moteur, alimenté par les deux drivers (mode jumelé, sans mixage)</translation></message>
    <message><source>has no motor: in joint mode both drivers power motor 1</source>
        <translation>n'a pas de moteur : en mode jumelé, les deux drivers alimentent le moteur 1</translation></message>
    <message><source>{0} ({1}) is outside the input range. {2} The output never reaches its full value on that side.</source>
        <translation>{0} ({1}) est hors de la plage de l'entrée. {2} La sortie maximale de ce côté n'est jamais atteinte.</translation></message>
    <message><source>is ignored: it is held at neutral, whatever its input</source>
        <translation>est ignorée : elle est maintenue au neutre, quelle que soit son entrée</translation></message>
    <message><source>In RC and analog mode it {1}.</source>
        <translation>En mode RC ou analogique, elle {1}.</translation></message>
    <message><source>The board now reads {0}, so it shows and accepts only the calibrations of this source. To see the calibrations for {1}, set Channel Input Source, apply, and switch the board off and on.</source>
        <translation>La carte lit actuellement : {0} ; elle n'affiche et n'accepte que les étalonnages correspondants. Pour voir ceux-ci, faites-lui lire : {1}. Réglez « Source des entrées des voies », appliquez, puis coupez et remettez l'alimentation de la carte.</translation></message>
    <message><source>The board now reads {0}, so it shows and accepts only the calibrations of this source. To see these calibrations, switch the board off, set the mode jumper to {2}, and switch the board on.</source>
        <translation>La carte lit actuellement : {0} ; elle n'affiche et n'accepte que les étalonnages correspondants. Pour voir ceux-ci : coupez son alimentation, placez le cavalier de mode sur {2}, remettez l'alimentation.</translation></message>
    <message><source>applied {0}</source>
        <translation>appliqué le {0}</translation></message>
    <message><source>read {0}</source>
        <translation>lu le {0}</translation></message>
    <message><source>Pulses range from {0} to {1}.</source>
        <translation>Une impulsion dure de {0} à {1}.</translation></message>
    <message><source>Voltages range from {0} to {1}.</source>
        <translation>Une tension va de {0} à {1}.</translation></message>
    <message><source>Neutral ({0}) is outside the input range. {1} No stick position gives 0.</source>
        <translation>Le neutre ({0}) est hors de la plage de l'entrée. {1} Aucune position du manche ne donne 0.</translation></message>
    <message><source>Minimum</source>
        <translation>Minimum</translation></message>
    <message><source>Maximum</source>
        <translation>Maximum</translation></message>
    <message><source>no signal</source>
        <translation>pas de signal</translation></message>
    <message><source>{0}, output {1}</source>
        <translation>{0}, sortie {1}</translation></message>
    <message><source>is ignored: it stays off, whatever its input</source>
        <translation>est ignorée : elle est maintenue inactive, quelle que soit son entrée</translation></message>
    <message><source>Has no effect now: serial commands override it. Otherwise it {1}.</source>
        <translation>Ne commande rien maintenant : les commandes série ont priorité. Sinon, elle {1}.</translation></message>
    <message><source>The deadband ({0} to each side of neutral) reaches {1}: no output between 0 and full is possible.</source>
        <translation>La zone morte ({0} de chaque côté du neutre) atteint {1} : il n'y a rien entre 0 et la sortie maximale.</translation></message>
    <message><source>below about {0} (inferred)</source>
        <translation>en dessous d'environ {0} (déduit)</translation></message>
    <message><source>above about {0} (inferred)</source>
        <translation>au-dessus d'environ {0} (déduit)</translation></message>
    <message><source>On now. It {1}.</source>
        <translation>Active maintenant. Elle {1}.</translation></message>
    <message><source>Channel {0} {1}.</source>
        <translation>La voie {0} {1}.</translation></message>
    <message><source>{0} The board accepts a calibration only if minimum is not above neutral, neutral is not above maximum, and minimum and maximum differ.</source>
        <translation>{0} Elle n'accepte un étalonnage que si le minimum n'est pas au-dessus du neutre, si le neutre n'est pas au-dessus du maximum, et si le minimum et le maximum sont différents.</translation></message>
    <message><source>{0} Your edits are kept.</source>
        <translation>{0} Les modifications sont conservées en attendant.</translation></message>
    <message><source>The board would reject this: {0}.</source>
        <translation>La carte le rejetterait : {0}.</translation></message>
    <message><source> and </source>
        <translation> et </translation></message>
    <message><source>{0} while the input is {1}</source>
        <translation>{0} tant que l'entrée est {1}</translation></message>
    <message><source>{0}; it is reversed</source>
        <translation>{0} ; elle est inversée</translation></message>
    <message><source>Not connected.</source>
        <translation>Pas connecté.</translation></message>
    <message><source>The board has stopped responding. Check its power. Waiting for a reply …</source>
        <translation>La carte a cessé de répondre. Est-elle sous tension ? Attente …</translation></message>
    <message><source>Selecting device {0} …</source>
        <translation>Sélection de l'appareil {0} …</translation></message>
    <message><source>Connected to {0}.</source>
        <translation>Connecté à {0}.</translation></message>
    <message><source>No reply yet. Trying other settings: {0} …</source>
        <translation>Pas encore de réponse. Essai d'autres réglages : {0} …</translation></message>
    <message><source>{0}: noisy; shorten cable, check ground</source>
        <translation>{0} : bruitée ; raccourcir le câble, vérifier la masse</translation></message>
    <message><source>Trying to reach the board to stop it …</source>
        <translation>Tentative de joindre la carte pour l'arrêter …</translation></message>
    <message><source>Line: good</source>
        <translation>Liaison : bonne</translation></message>
    <message><source>{0:.1f} % lost</source>
        <translation>{0:.1f} % de pertes</translation></message>
    <message><source>{0}: noisy; shorten cable, check ground, use CRC</source>
        <translation>{0} : bruitée ; raccourcir le câble, vérifier la masse, utiliser le CRC</translation></message>
    <message><source>{0} A stop was sent but is not confirmed yet.</source>
        <translation>{0} Un ordre d'arrêt a été envoyé, mais n'est pas encore confirmé.</translation></message>
    <message><source>{0}. The stop is not confirmed: {1} If a motor is still turning, cut its power.</source>
        <translation>{0}. L'arrêt n'est pas confirmé : {1} Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>{0}, so the motors were stopped.</source>
        <translation>{0} : les moteurs ont donc été arrêtés.</translation></message>
    <message><source>{0}. Motors may still be turning: cut their power. No board is connected, so no stop can be sent.</source>
        <translation>{0}. Aucune carte n'est connectée qui puisse être arrêtée, et les moteurs peuvent encore tourner : coupez leur alimentation.</translation></message>
    <message><source>{0}. The board has confirmed the stop.</source>
        <translation>{0}. La carte a confirmé l'arrêt.</translation></message>
    <message><source>{0}. The connection is closed.</source>
        <translation>{0}. La liaison est fermée.</translation></message>
    <message><source>Learning: remove the Mix jumper to begin.</source>
        <translation>Apprentissage : retirez le cavalier Mix pour commencer.</translation></message>
    <message><source>Learning: waiting for a signal on any input.</source>
        <translation>Apprentissage : attend un signal sur une entrée.</translation></message>
    <message><source>Learning: leave the sticks centred for two seconds.</source>
        <translation>Apprentissage : laissez les manches centrés deux secondes.</translation></message>
    <message><source>Learning: one flash per input; green means learned.</source>
        <translation>Apprentissage : un clignotement par entrée ; vert signifie apprise.</translation></message>
    <message><source>Learning: hold each stick at both ends, ten seconds in all.</source>
        <translation>Apprentissage : maintenez chaque manche aux deux extrémités, dix secondes en tout.</translation></message>
    <message><source>Learned; green means good. Remove SO–G, then power-cycle.</source>
        <translation>Apprentissage terminé ; vert signifie réussi. Retirez SO–G, puis coupez et remettez l'alimentation.</translation></message>
    <message><source>Boot loader: remove Mix, then SO–G.</source>
        <translation>Chargeur d'amorçage : retirez Mix, puis SO–G.</translation></message>
    <message><source>Boot loader: waiting for firmware. Power-cycle to exit.</source>
        <translation>Chargeur d'amorçage : attend un firmware. Coupez et remettez l'alimentation pour en sortir.</translation></message>
    <message><source>Edits, notes or settings of another board with this device number were already saved. They were moved to {0}.</source>
        <translation>Des modifications, des notes ou des réglages étaient conservés ici pour une autre carte ayant ce numéro d'appareil. Ils se trouvent maintenant dans {0}.</translation></message>
    <message><source>The settings could not be read again. {0}</source>
        <translation>La relecture a échoué. {0}</translation></message>
    <message numerus="yes"><source>%n unapplied edit(s) of the previous {0} saved. They are offered when that board is connected again.</source>
        <translation><numerusform>%n modification non appliquée à l'appareil précédent ({0}) : elle est conservée, et proposée quand il sera reconnecté.</numerusform><numerusform>%n modifications non appliquées à l'appareil précédent ({0}) : elles sont conservées, et proposées quand il sera reconnecté.</numerusform></translation></message>
    <message numerus="yes"><source>%n earlier change(s) still pending. Review them to write to this board.</source>
        <translation><numerusform>%n modification antérieure encore en attente. Vérifiez-la pour l'écrire dans cette carte.</numerusform><numerusform>%n modifications antérieures encore en attente. Vérifiez-les pour les écrire dans cette carte.</numerusform></translation></message>
    <message><source>Nothing was written: another board was selected.</source>
        <translation>Rien n'a été écrit : une autre carte a été sélectionnée.</translation></message>
    <message numerus="yes"><source>%n edit(s) of the previous board saved. They return when that board is selected again.</source>
        <translation><numerusform>%n modification de la carte précédente conservée : elle revient quand cette carte est de nouveau sélectionnée.</numerusform><numerusform>%n modifications de la carte précédente conservées : elles reviennent quand cette carte est de nouveau sélectionnée.</numerusform></translation></message>
    <message><source>Nothing was written: the board does not respond.</source>
        <translation>Rien n'a été écrit : la carte ne répond pas.</translation></message>
    <message><source>Noise on the line can make a motor turn the wrong way for a moment.</source>
        <translation>Du bruit sur la liaison peut faire tourner un moteur un instant dans un autre sens.</translation></message>
    <message><source>Board {0}: {1}</source>
        <translation>Carte {0} : {1}</translation></message>
    <message><source>Stop</source>
        <translation>Arrêt</translation></message>
    <message><source>Nothing was written: the settings read from the board have changed.</source>
        <translation>Rien n'a été écrit : d'autres réglages ont été lus dans la carte.</translation></message>
    <message><source>The network is not responding; the robot's server stops the motors.</source>
        <translation>Le réseau est muet ; le serveur du robot arrête les moteurs.</translation></message>
    <message><source>{0} and {1} more</source>
        <translation>{0} et encore {1}</translation></message>
    <message><source>Apply: {0}</source>
        <translation>Appliqué : {0}</translation></message>
    <message><source>Stop: {0}</source>
        <translation>Arrêt : {0}</translation></message>
    <message><source>{0} ({1} failed)</source>
        <translation>{0} (échecs : {1})</translation></message>
    <message><source>The connection is not responding, so the stop could not be sent.</source>
        <translation>La connexion ne répond pas ; l'ordre d'arrêt n'a donc pas pu être envoyé.</translation></message>
    <message><source>The stop may not have reached the {0} that was driven at {1}: another board responded. If a motor of that board is still turning, cut its power.</source>
        <translation>Rien n'indique qu'un arrêt ait atteint la carte {0} qui était pilotée sur {1} : une autre carte a répondu. Si un moteur de la première tourne encore, coupez son alimentation.</translation></message>
    <message><source>Another board responds now: {0}, at {1}.</source>
        <translation>Une autre carte répond maintenant : {0}, sur {1}.</translation></message>
    <message><source>The connection to {0} was lost before a stop was confirmed. The board now at this port has confirmed a stop. If this is another board, cut the power of the first board.</source>
        <translation>La liaison avec {0} a été perdue avant la confirmation d'un arrêt. La carte de ce port en a confirmé un ; si c'est une autre carte, coupez l'alimentation de la première.</translation></message>
    <message><source>The connection is not responding.</source>
        <translation>La connexion ne répond pas.</translation></message>
    <message><source>The guardian process is sending the stop now.</source>
        <translation>Le processus gardien l'envoie maintenant.</translation></message>
    <message><source>The guardian process stopped the motors, and the board confirmed it.</source>
        <translation>Le processus gardien a arrêté les moteurs et la carte l'a confirmé.</translation></message>
    <message><source>The board that was lost while it was driven is back.</source>
        <translation>La carte qui s'était déconnectée pendant la conduite est de retour.</translation></message>
    <message><source>This may be another board: the settings of {0}, at {1}, differ from those of the board that was driven.</source>
        <translation>C'est peut-être une autre carte : {0}, sur {1}, ne contient pas les réglages de celle qui était pilotée.</translation></message>
    <message><source>{0}, device {1}</source>
        <translation>{0}, appareil {1}</translation></message>
    <message><source>{0} The motors were stopped. Arm the motors again to continue.</source>
        <translation>{0} Les moteurs ont été arrêtés. Réactivez-les pour continuer.</translation></message>
    <message><source>A setting of the board changed, so the motors were stopped.</source>
        <translation>Un réglage de la carte a changé ; les moteurs ont donc été arrêtés.</translation></message>
    <message><source>The board was restarted, so the motors were stopped.</source>
        <translation>La carte a été redémarrée ; les moteurs ont donc été arrêtés.</translation></message>
    <message><source>Connect to a board first.</source>
        <translation>Connectez d'abord une carte.</translation></message>
    <message><source>Settings are being written.</source>
        <translation>Des réglages sont en cours d'écriture.</translation></message>
    <message><source>The motors were stopped and stay locked for another {0:.0f} s.</source>
        <translation>Après un arrêt, les moteurs restent verrouillés pendant encore {0:.0f} s.</translation></message>
    <message><source>Another control is driving now.</source>
        <translation>Une autre commande pilote maintenant.</translation></message>
    <message><source>{0} A test needs serial control.</source>
        <translation>{0} Un essai nécessite la commande par liaison série.</translation></message>
    <message><source>Stop the motors first ({0}).</source>
        <translation>Mettez d'abord les moteurs au repos ({0}).</translation></message>
    <message><source>coast</source>
        <translation>roue libre</translation></message>
    <message><source>no limit</source>
        <translation>sans limite</translation></message>
    <message><source>Serial timeout is off: motors keep turning if the cable or this computer fails.</source>
        <translation>Le délai série est désactivé : les moteurs continuent de tourner si le câble ou cet ordinateur tombe en panne.</translation></message>
    <message><source>Serial timeout is off, and the guardian process could not be started: motors keep turning if the cable, this computer or this program fails.</source>
        <translation>Le délai série est désactivé, et le processus gardien n'a pas pu être démarré : les moteurs continuent de tourner si le câble, cet ordinateur ou ce programme tombe en panne.</translation></message>
    <message><source>brake, {0}</source>
        <translation>freinage, {0}</translation></message>
    <message><source>forward</source>
        <translation>avant</translation></message>
    <message><source>reverse</source>
        <translation>arrière</translation></message>
    <message><source>no current sensing in joint mode</source>
        <translation>pas de mesure de courant en mode jumelé</translation></message>
    <message><source>limit {0:.1f} A</source>
        <translation>limite {0:.1f} A</translation></message>
    <message><source>Serial timeout is on, but did not stop the motors of this board when it was tested: motors keep turning if the cable or this computer fails.</source>
        <translation>Le délai série est activé, mais il n'a pas arrêté les moteurs de cette carte lors de l'essai : ils continuent de tourner si le câble ou cet ordinateur tombe en panne.</translation></message>
    <message><source>channel {0} at {1} (overridden)</source>
        <translation>voie {0} à {1} (priorité série)</translation></message>
    <message><source>UART-Error Shutdown is off: motors may keep turning if the cable or this computer fails, although the serial timeout is on (twin).</source>
        <translation>« Arrêt sur erreur UART » est désactivé : les moteurs peuvent continuer de tourner si le câble ou cet ordinateur tombe en panne, bien que le délai série soit activé (jumeau).</translation></message>
    <message><source>UART-Error Shutdown is off, and the serial timeout did not stop the motors of this board when it was tested: motors keep turning if the cable or this computer fails.</source>
        <translation>« Arrêt sur erreur UART » est désactivé, et le délai série n'a pas arrêté les moteurs de cette carte lors de l'essai : ils continuent de tourner si le câble ou cet ordinateur tombe en panne.</translation></message>
    <message><source>The guardian process could not be started: if this program fails, motors keep turning until the serial timeout of {0:g} s expires.</source>
        <translation>Le processus gardien n'a pas pu être démarré : si ce programme tombe en panne, les moteurs continuent de tourner pendant le délai série de {0:g} s.</translation></message>
    <message><source>The serial timeout of {0:g} s is short for a network port: one late reply stops the motors while you drive. Set a longer timeout, or connect the board to this computer.</source>
        <translation>Un délai série de {0:g} s est court pour un port réseau : une seule réponse tardive arrête les moteurs pendant la conduite. Réglez un délai plus long, ou connectez la carte à cet ordinateur.</translation></message>
    <message><source>The serial timeout of {0:g} s is short for {1} baud: one lost reply stops the motors while you drive. Set a longer timeout or a higher baud rate.</source>
        <translation>Un délai série de {0:g} s est court pour {1} bauds : une seule réponse perdue arrête les moteurs pendant la conduite. Réglez un délai plus long, ou un débit plus élevé.</translation></message>
    <message><source>left stick, sideways</source>
        <translation>manche gauche, horizontal</translation></message>
    <message><source>left stick, up and down</source>
        <translation>manche gauche, vertical</translation></message>
    <message><source>right stick, sideways</source>
        <translation>manche droit, horizontal</translation></message>
    <message><source>right stick, up and down</source>
        <translation>manche droit, vertical</translation></message>
    <message><source>left trigger</source>
        <translation>gâchette gauche</translation></message>
    <message><source>right trigger</source>
        <translation>gâchette droite</translation></message>
    <message><source>left shoulder</source>
        <translation>bouton de tranche gauche</translation></message>
    <message><source>right shoulder</source>
        <translation>bouton de tranche droit</translation></message>
    <message><source>left stick pressed</source>
        <translation>manche gauche enfoncé</translation></message>
    <message><source>right stick pressed</source>
        <translation>manche droit enfoncé</translation></message>
    <message><source>D-pad up</source>
        <translation>croix haut</translation></message>
    <message><source>D-pad down</source>
        <translation>croix bas</translation></message>
    <message><source>D-pad left</source>
        <translation>croix gauche</translation></message>
    <message><source>D-pad right</source>
        <translation>croix droite</translation></message>
    <message><source>A (the bottom button)</source>
        <translation>A, le plus bas des quatre</translation></message>
    <message><source>B (the right button)</source>
        <translation>B, le plus à droite des quatre</translation></message>
    <message><source>X (the left button)</source>
        <translation>X, le plus à gauche des quatre</translation></message>
    <message><source>Y (the top button)</source>
        <translation>Y, le plus haut des quatre</translation></message>
    <message><source>Arm the motors first.</source>
        <translation>Activez d'abord les moteurs.</translation></message>
    <message><source>Driving with a gamepad was switched off.</source>
        <translation>La conduite à la manette a été désactivée.</translation></message>
    <message><source>Another gamepad was selected.</source>
        <translation>Une autre manette a été choisie.</translation></message>
    <message><source>The gamepad settings were changed.</source>
        <translation>Les réglages de la manette ont été modifiés.</translation></message>
    <message><source>No gamepad is connected. Plug in or switch on a gamepad.</source>
        <translation>Aucune manette n'est connectée. Branchez-en une ou allumez-la.</translation></message>
    <message><source>Release the sticks: driving starts only once both axes have been at rest. A worn stick may need a wider dead zone.</source>
        <translation>Relâchez les manches : la conduite ne commence que lorsque les deux axes ont été au repos. Un manche usé peut nécessiter une zone morte plus large.</translation></message>
    <message><source>Release {0}, then hold it to drive.</source>
        <translation>Relâchez le {0}, puis maintenez-le enfoncé pour piloter.</translation></message>
    <message><source>Hold {0} and move a stick to drive.</source>
        <translation>Maintenez le {0} enfoncé et bougez un manche pour piloter.</translation></message>
    <message><source>Move a stick to drive.</source>
        <translation>Bougez un manche pour piloter.</translation></message>
    <message><source>Driving. Release the sticks to stop.</source>
        <translation>Conduite en cours. Relâchez les manches pour arrêter.</translation></message>
    <message><source>Driving. Release {0} to stop.</source>
        <translation>Conduite en cours. Relâchez le {0} pour arrêter.</translation></message>
    <message><source>button {0}</source>
        <translation>bouton {0}</translation></message>
    <message><source>axis {0}</source>
        <translation>axe {0}</translation></message>
    <message><source>The gamepad “{0}” was disconnected.</source>
        <translation>La manette « {0} » a été déconnectée.</translation></message>
    <message><source>Active above {0}, halfway between neutral and maximum (inferred).</source>
        <translation>Active au-dessus de {0}, à mi-chemin entre le neutre et le maximum (déduit).</translation></message>
    <message><source>Active below {0}, halfway between neutral and minimum (inferred).</source>
        <translation>Active en dessous de {0}, à mi-chemin entre le neutre et le minimum (déduit).</translation></message>
    <message><source>At rest the switch is active.</source>
        <translation>Au repos, elle est active.</translation></message>
    <message><source>At rest the switch is off.</source>
        <translation>Au repos, elle est inactive.</translation></message>
    <message><source>Cannot continue: the stop of the motors is not confirmed. {0}</source>
        <translation>Impossible de continuer : l'arrêt des moteurs n'a pas pu être confirmé. {0}</translation></message>
    <message><source>The test has ended. Nothing in the board was changed.</source>
        <translation>Le test est terminé ; il ne change rien dans la carte.</translation></message>
    <message><source>Nothing was changed.</source>
        <translation>Rien n'a été modifié.</translation></message>
    <message><source>&amp;Learn channels…</source>
        <translation>Apprendre les &amp;voies…</translation></message>
    <message><source>These values are already stored.</source>
        <translation>Ces valeurs sont déjà enregistrées.</translation></message>
    <message><source>The board accepted the stop, but {0}. Check the motors. If a motor is turning, cut its power: something else is driving it, such as another controller on this line. Continue only if no motor is turning.</source>
        <translation>La carte a accepté l'arrêt, mais {0}. Contrôlez les moteurs : si l'un d'eux tourne, autre chose le commande, par exemple un autre contrôleur sur cette liaison ; coupez l'alimentation de ce moteur. Ne continuez que s'ils ne tournent pas.</translation></message>
    <message><source>The learned values are stored.</source>
        <translation>Ce qui a été appris est enregistré.</translation></message>
    <message><source>The board is in {0} mode: the sticks drive the motors, and the board rejects settings. Switch the board off, remove the mode jumper and switch the board on.</source>
        <translation>La carte est en mode {0} : les manches commandent les moteurs, et elle rejette les réglages. Coupez son alimentation, retirez le cavalier de mode et remettez l'alimentation.</translation></message>
    <message><source>The board is in {0} mode. Channel 5 has switched the motors to serial control; when its switch moves again, the sticks drive the motors. In this mode the board rejects settings. Switch the board off, remove the mode jumper and switch the board on.</source>
        <translation>La carte est en mode {0}. La voie 5 a cédé les moteurs à la liaison série, mais au prochain mouvement de son interrupteur, les manches commanderont de nouveau les moteurs ; de plus, la carte rejette les réglages. Coupez son alimentation, retirez le cavalier de mode et remettez l'alimentation.</translation></message>
    <message><source>The board was started in another mode.</source>
        <translation>La carte a été démarrée dans un autre mode.</translation></message>
    <message><source>The motors were armed, so this has ended.</source>
        <translation>Les moteurs ont été activés ; l'opération est donc terminée.</translation></message>
    <message><source>The sticks drive the motors now: the channels are in control.</source>
        <translation>Les manches commandent maintenant les moteurs : la commande est passée aux voies.</translation></message>
    <message><source>motor {0} draws {1:.1f} A</source>
        <translation>le moteur {0} consomme {1:.1f} A</translation></message>
    <message><source>The signal moved during sampling, between {0} and {1}. Release the stick and sample again.</source>
        <translation>La valeur a bougé pendant la mesure, entre {0} et {1}. Lâchez tout et refaites la mesure.</translation></message>
    <message><source>Release the stick and sample again. If the drift continues, the stick or the transmitter is warming up or worn.</source>
        <translation>Lâchez tout et refaites la mesure ; si cela continue, le manche ou l'émetteur est en train de chauffer, ou usé.</translation></message>
    <message><source>Move the transmitter closer, or check the antenna and the cable.</source>
        <translation>Rapprochez l'émetteur, ou vérifiez l'antenne et le câble.</translation></message>
    <message><source>At rest the noise is {0}: a deadband wide enough to hide this noise would take a quarter of the travel. Repair the cable, the supply or the stick first.</source>
        <translation>Au repos, son bruit est de {0} : une zone morte assez large pour le masquer prendrait un quart de la course. Réparez d'abord le câble, l'alimentation ou le manche.</translation></message>
    <message><source>An unconnected input behaves in the same way.</source>
        <translation>Une entrée à laquelle rien n'est raccordé fait cela aussi.</translation></message>
    <message><source>Either nothing is connected to this input (its voltage is then meaningless), or its stick was not moved.</source>
        <translation>Soit rien n'y est raccordé (sa tension ne signifie alors rien), soit ce qui y est raccordé n'a pas été bougé.</translation></message>
    <message><source>At least {1} is needed: the deadband plus one count for each of the {2} speeds.</source>
        <translation>Il faut au moins {1} : la zone morte, et un count pour chacune des {2} vitesses.</translation></message>
    <message><source>Push the stick in the other direction, too. If this is not possible, the stick was at an end during sampling.</source>
        <translation>Poussez le manche aussi dans l'autre sens ; s'il ne peut pas y aller, il était à une extrémité pendant la mesure.</translation></message>
    <message><source>The stick moved in one direction only.</source>
        <translation>La valeur n'est allée que dans un sens.</translation></message>
    <message><source>Go back, push the stick all the way and hold this position for {0:.1f} s.</source>
        <translation>Revenez en arrière, poussez le manche jusqu'au bout et maintenez-l'y {0:.1f} s.</translation></message>
    <message><source>The stick moved {0} to one side, but only {1} to the other side.</source>
        <translation>La valeur est allée à {0} d'un côté, mais seulement à {1} de l'autre.</translation></message>
    <message><source>Was the stick pushed all the way?</source>
        <translation>Le manche a-t-il été poussé jusqu'au bout ?</translation></message>
    <message><source>Should the channel be reversed?</source>
        <translation>Faut-il l'inverser, ou non ?</translation></message>
    <message><source>No signal: no valid pulse arrives.</source>
        <translation>Pas de signal : aucune impulsion valide n'arrive.</translation></message>
    <message><source>Is the transmitter on, and is the receiver connected to this channel?</source>
        <translation>L'émetteur est-il allumé, et le récepteur est-il raccordé à cette voie ?</translation></message>
    <message><source>No signal.</source>
        <translation>Pas de signal.</translation></message>
    <message><source>The signal drifted up by {0} during sampling.</source>
        <translation>La valeur a dérivé de {0} vers le haut pendant la mesure.</translation></message>
    <message><source>The signal drifted down by {0} during sampling.</source>
        <translation>La valeur a dérivé de {0} vers le bas pendant la mesure.</translation></message>
    <message><source>The signal comes and goes: {0:.0%} of the samples had no valid pulse.</source>
        <translation>Le signal va et vient : {0:.0%} des échantillons n'avaient pas d'impulsion valide.</translation></message>
    <message><source>Outlying pulses: {0} of {1}.</source>
        <translation>Impulsions très éloignées de toutes les autres : {0} sur {1}.</translation></message>
    <message><source>The radio link is poor, or the cable picks up noise.</source>
        <translation>La liaison radio est mauvaise, ou le câble capte des parasites.</translation></message>
    <message><source>About {0:.0%} of the pulses are lost (estimated: the value often repeats where it otherwise varies).</source>
        <translation>Environ {0:.0%} des impulsions sont perdues (estimation : la valeur se répète souvent là où elle varie d'habitude).</translation></message>
    <message><source>The board repeats the last value, so losses below a third, or losses in a steadier signal, cannot be detected.</source>
        <translation>La carte répète la dernière valeur ; des pertes inférieures à un tiers, ou d'un signal plus stable, passent donc inaperçues.</translation></message>
    <message><source>At rest the noise is {0}, more than the deadband ({1}): the motor would creep.</source>
        <translation>Au repos, le bruit est de {0}, plus que la zone morte ({1}) : le moteur tournerait lentement tout seul.</translation></message>
    <message><source>A steady signal arrives, but it never moved.</source>
        <translation>La valeur n'a jamais bougé, bien qu'un signal stable arrive.</translation></message>
    <message><source>Either another stick controls this channel, or the stick was not moved.</source>
        <translation>Soit un autre manche commande cette voie, soit le sien n'a pas été bougé.</translation></message>
    <message><source>This input does not change: it stays at {0}.</source>
        <translation>Rien ne bouge sur cette entrée : elle reste à {0}.</translation></message>
    <message><source>This input does not change: it stays at {0}, an end of the measuring range.</source>
        <translation>Rien ne bouge sur cette entrée : elle reste à {0}, une extrémité de la plage de mesure.</translation></message>
    <message><source>The stick moved only {0} from its rest position.</source>
        <translation>La valeur ne s'est éloignée que de {0} de sa position de repos.</translation></message>
    <message><source>The low end is only {0} from the rest position.</source>
        <translation>L'extrémité basse n'est qu'à {0} de la position de repos.</translation></message>
    <message><source>The high end is only {0} from the rest position.</source>
        <translation>L'extrémité haute n'est qu'à {0} de la position de repos.</translation></message>
    <message><source>The low end was only passed, not held.</source>
        <translation>L'extrémité basse n'a été atteinte qu'en passant, sans maintien.</translation></message>
    <message><source>The high end was only passed, not held.</source>
        <translation>L'extrémité haute n'a été atteinte qu'en passant, sans maintien.</translation></message>
    <message><source>Both ends were only passed, not held.</source>
        <translation>Les deux extrémités n'ont été atteintes qu'en passant, sans maintien.</translation></message>
    <message><source>The rest position ({0}) is not between the ends ({1} and {2}).</source>
        <translation>Sa position de repos ({0}) n'est pas entre ses extrémités ({1} et {2}).</translation></message>
    <message><source>Was a trim moved? Begin again with the sticks at rest.</source>
        <translation>Un trim a-t-il été bougé ? Recommencez avec les manches au repos.</translation></message>
    <message><source>The stick rests at {0}: with this neutral, the output there would be {1}.</source>
        <translation>Au repos, la voie est à {0} : avec ce neutre, elle donnerait {1} à cet endroit.</translation></message>
    <message><source>After release the stick rests at {0}, not at {1}, and the output there would be {2}.</source>
        <translation>Une fois relâchée, la voie reste à {0}, et non à {1}, et donnerait {2} à cet endroit.</translation></message>
    <message><source>Was a hand on the stick during sampling, or was a trim moved?</source>
        <translation>Une main y était-elle posée pendant la mesure, ou un trim a-t-il été bougé ?</translation></message>
    <message><source>Go back and sample the channel again, or use the new rest position.</source>
        <translation>Revenez en arrière et refaites la mesure, ou utilisez la nouvelle position de repos.</translation></message>
    <message><source>{0} is beyond {1}, the farthest value reached: the output cannot reach its full value.</source>
        <translation>{0} est au-delà de la valeur atteinte ({1}) : il n'y a pas de sortie maximale.</translation></message>
    <message><source>Beyond the rest position the motor speeds up again: at {0}, to {1} of {2} in either direction.</source>
        <translation>Au-delà de la position de repos, le moteur accélère de nouveau, quel que soit le signe : à {0}, jusqu'à {1} sur {2}.</translation></message>
    <message><source>Check that no trim and no broken wire can move the signal there.</source>
        <translation>Vérifiez qu'aucun trim ni aucun fil coupé ne peut l'y amener.</translation></message>
    <message><source>The rest position ({0}) is too close to the switching point ({1}).</source>
        <translation>Sa position de repos ({0}) est trop proche de son point de basculement ({1}).</translation></message>
    <message><source>The channel may switch by itself.</source>
        <translation>Elle peut basculer d'elle-même.</translation></message>
    <message><source>The switch is active in all its positions: none is beyond the switching point, {0}.</source>
        <translation>Elle est active dans toutes ses positions : aucune n'est au-delà de {0}, où elle bascule.</translation></message>
    <message><source>The switch is inactive in all its positions: none is beyond the switching point, {0}.</source>
        <translation>Elle est inactive dans toutes ses positions : aucune n'est au-delà de {0}, où elle bascule.</translation></message>
    <message><source>In {0} mode safe-start would release the motors now.</source>
        <translation>En mode {0}, le démarrage sécurisé libérerait les moteurs maintenant.</translation></message>
    <message><source>Ignored: the board holds this channel at neutral. There is nothing to test.</source>
        <translation>Ignorée : la carte la maintient au neutre. Il n'y a rien à tester.</translation></message>
    <message><source>Good.</source>
        <translation>C'est bon.</translation></message>
    <message><source>Only {0} was detected. Move the switch to its other position.</source>
        <translation>Seule la position « {0} » a été vue. Mettez l'interrupteur dans son autre position.</translation></message>
    <message><source>Full output not reached yet. Push the stick all the way.</source>
        <translation>Sortie maximale pas encore atteinte. Poussez jusqu'au bout.</translation></message>
    <message><source>Full output not reached yet: {0}.</source>
        <translation>Sortie maximale pas encore atteinte : {0}.</translation></message>
    <message><source>Full output reached. Let the stick rest for a moment.</source>
        <translation>Sortie maximale atteinte. Laissez au repos un instant.</translation></message>
    <message><source>In {0} mode safe-start would hold the motors now. {1}</source>
        <translation>En mode {0}, le démarrage sécurisé bloquerait les moteurs maintenant. {1}</translation></message>
    <message><source>Move the switch to all its positions.</source>
        <translation>Mettez l'interrupteur dans toutes ses positions.</translation></message>
    <message><source>Full output reached. Release the stick: at rest the output must be 0, but it is {0}.</source>
        <translation>Sortie maximale atteinte. Relâchez : au repos, la sortie doit être 0, mais elle est {0}.</translation></message>
    <message><source>off</source>
        <translation>désactivé</translation></message>
    <message><source>on</source>
        <translation>activé</translation></message>
    <message><source>The board is back. It has confirmed the stop.</source>
        <translation>La carte est de retour. Elle a confirmé l'arrêt.</translation></message>
    <message><source>The board is back. It has confirmed the stop. It received nothing for {0:.0f} s: did its Serial Timeout stop the motor during that time?</source>
        <translation>La carte est de retour. Elle a confirmé l'arrêt. Pendant {0:.0f} s, elle n'a rien reçu : son « Délai série » a-t-il arrêté le moteur entre-temps ?</translation></message>
    <message><source>It stopped</source>
        <translation>Il s'est arrêté</translation></message>
    <message><source>It kept turning</source>
        <translation>Il a continué de tourner</translation></message>
    <message><source>brake</source>
        <translation>freinage</translation></message>
    <message><source>motor {0}</source>
        <translation>moteur {0}</translation></message>
    <message><source>left</source>
        <translation>gauche</translation></message>
    <message><source>right</source>
        <translation>droite</translation></message>
    <message><source>auxiliary {0}</source>
        <translation>auxiliaire {0}</translation></message>
    <message><source>Hexadecimal, such as 9F 07</source>
        <translation>Hexadécimal, par exemple 9F 07</translation></message>
    <message><source>A stop would not reach that board: address device {0}.</source>
        <translation>Un arrêt n'atteindrait pas cette carte : adressez l'appareil {0}.</translation></message>
    <message><source>{0}: {1}</source>
        <translation>{0} : {1}</translation></message>
    <message numerus="yes"><source>and %n more packet(s)</source>
        <translation><numerusform>et encore %n paquet</numerusform><numerusform>et encore %n paquets</numerusform></translation></message>
    <message><source>Every board on this line would store the value: address device {0}.</source>
        <translation>Toutes les cartes de cette liaison l'enregistreraient : adressez l'appareil {0}.</translation></message>
    <message><source>Every board on this line would store the value: select a board.</source>
        <translation>Toutes les cartes de cette liaison l'enregistreraient : sélectionnez l'une d'elles.</translation></message>
    <message><source>Sent {0}; the reply is {1}.</source>
        <translation>{0} envoyé ; la réponse est {1}.</translation></message>
    <message><source>Sent {0}; there was no reply.</source>
        <translation>{0} envoyé ; il n'y a pas eu de réponse.</translation></message>
    <message><source>{0} (may move a motor)</source>
        <translation>{0} (peut faire tourner un moteur)</translation></message>
    <message><source>{0} (stored at once, without a snapshot)</source>
        <translation>{0} (enregistré aussitôt, sans instantané)</translation></message>
    <message><source>Sent by hand: {0}</source>
        <translation>Envoyé à la main : {0}</translation></message>
    <message><source>Parameter</source>
        <translation>Paramètre</translation></message>
    <message><source>Motors and speed ramp</source>
        <translation>Moteurs et rampe de vitesse</translation></message>
    <message><source>Braking</source>
        <translation>Freinage</translation></message>
    <message><source>Current</source>
        <translation>Courant</translation></message>
    <message><source>PWM</source>
        <translation>PWM</translation></message>
    <message><source>Inputs</source>
        <translation>Entrées</translation></message>
    <message><source>Serial</source>
        <translation>Liaison série</translation></message>
    <message><source>System</source>
        <translation>Système</translation></message>
    <message><source>{0} ({1} modified)</source>
        <translation>{0} ({1} modifiés)</translation></message>
    <message><source>Motors 1 and 2 {0}</source>
        <translation>Moteurs 1 et 2 : {0}</translation></message>
    <message><source>{0}: {1} is not a valid value.</source>
        <translation>{0}: {1} n'est pas une valeur valide.</translation></message>
    <message><source>Switching frequency of the motor's PWM. Low frequencies make the motor whine and heat up; frequencies above the driver's rating heat the driver. Type a number or use the arrow keys. The board stores the nearest frequency that it supports.</source>
        <translation>Nombre de commutations par seconde du PWM du moteur. Une fréquence basse fait siffler et chauffer le moteur, une fréquence supérieure à la valeur nominale du driver fait chauffer celui-ci. Tapez un nombre ou utilisez les flèches. La carte enregistre la fréquence de commutation possible la plus proche.</translation></message>
    <message><source>This firmware has also stored wire values outside this range: {0}.</source>
        <translation>Ce firmware a enregistré au-delà : valeur transmise {0}.</translation></message>
    <message><source>(twin): documented for Pololu's qik 2s12v10, which has the same motor drivers.</source>
        <translation>(jumeau) : documenté pour le qik 2s12v10 de Pololu, qui a les mêmes drivers de moteur.</translation></message>
    <message><source>(inferred): not confirmed by any document.</source>
        <translation>(déduit) : aucun document ne le confirme.</translation></message>
    <message><source>PWM Frequency</source>
        <translation>Fréquence PWM</translation></message>
    <message><source>Takes effect when the board is switched off and on.</source>
        <translation>Prend effet quand l'alimentation de la carte est coupée puis remise.</translation></message>
    <message><source>{0} to {1}</source>
        <translation>{0} à {1}</translation></message>
    <message><source>{0} PWM Frequency</source>
        <translation>{0} : fréquence PWM</translation></message>
    <message><source>not given</source>
        <translation>non indiqué</translation></message>
    <message><source>not read</source>
        <translation>non lu</translation></message>
    <message><source>{0}, was {1}</source>
        <translation>{0}, avant {1}</translation></message>
    <message><source>{0} · default: {1}</source>
        <translation>{0} · par défaut : {1}</translation></message>
    <message><source>User's guide</source>
        <translation>Guide d'utilisation de la carte</translation></message>
    <message><source>{0} differs: {1}.</source>
        <translation>{0} diffère : {1}.</translation></message>
    <message><source>Reset to default: {0}</source>
        <translation>Réinitialiser à la valeur par défaut : {0}</translation></message>
    <message><source>{0}: {1}.</source>
        <translation>{0} : {1}.</translation></message>
    <message><source>{0:.0f} Hz</source>
        <translation>{0:.0f} Hz</translation></message>
    <message><source>prescaler {0}, maximum {1}</source>
        <translation>prédiviseur {0}, maximum {1}</translation></message>
    <message><source>Range: {0}{1}.</source>
        <translation>Plage : {0}{1}.</translation></message>
    <message><source>Default: {0}{1}.</source>
        <translation>Valeur par défaut : {0}{1}.</translation></message>
    <message><source>User's guide, section {0}</source>
        <translation>Guide d'utilisation, section {0}</translation></message>
    <message><source>wire {0}</source>
        <translation>valeur transmise {0}</translation></message>
    <message><source>Wire value: {0}.</source>
        <translation>Valeur transmise : {0}.</translation></message>
    <message><source>The meaning of the wire values is undocumented{0}.</source>
        <translation>Aucune source ne dit ce que signifient les valeurs transmises{0}.</translation></message>
    <message><source>Still active: {0}.</source>
        <translation>Encore actif : {0}.</translation></message>
    <message><source>{0} {1}</source>
        <translation>{0} {1}</translation></message>
    <message><source>Set up as {0}</source>
        <translation>Configurée comme {0}</translation></message>
    <message><source>Recording {0} ended: the board or its input source has changed.</source>
        <translation>L'enregistrement {0} s'est terminé : la carte ou sa source des entrées a changé.</translation></message>
    <message><source>The records of this board cannot be used. {0}</source>
        <translation>Les données de cette carte ne peuvent pas être utilisées. {0}</translation></message>
    <message><source>calibration of channel {0}: {1}</source>
        <translation>étalonnage de la voie {0} : {1}</translation></message>
    <message><source>Setting</source>
        <translation>Réglage</translation></message>
    <message><source>Wire</source>
        <translation>Valeur transmise</translation></message>
    <message><source>Result</source>
        <translation>Résultat</translation></message>
    <message><source>stored</source>
        <translation>enregistré</translation></message>
    <message><source>Note: {0}</source>
        <translation>Note : {0}</translation></message>
    <message><source>{0}; it is shown as Western European text. Check the characters that are not plain letters; Save writes UTF-8</source>
        <translation>{0} ; il est affiché comme texte d'Europe occidentale. Vérifiez les caractères qui ne sont pas de simples lettres ; l'enregistrement écrit en UTF-8</translation></message>
    <message><source>{0} is left out because it could not be read from the board.</source>
        <translation>{0} est omis : impossible de le lire dans la carte.</translation></message>
    <message><source>The {0} calibrations are left out: the board accepts them only while its input source is {0}.</source>
        <translation>Les étalonnages {0} sont omis : la carte ne les accepte que si elle lit ses entrées en {0}.</translation></message>
    <message><source>These settings are for a {0}, not a {1}</source>
        <translation>Ces réglages sont pour un {0}, pas pour un {1}</translation></message>
    <message><source>Reset to factory defaults</source>
        <translation>Réinitialisation aux réglages d'usine</translation></message>
    <message><source>There are no settings to compare with</source>
        <translation>Il n'y a pas de réglages auxquels comparer</translation></message>
    <message><source>Note on {0}</source>
        <translation>Note sur {0}</translation></message>
    <message><source>Discard edits</source>
        <translation>Abandonner les modifications</translation></message>
    <message><source>Unapplied edits cannot be saved for the next start. {0}</source>
        <translation>Les modifications non appliquées ne peuvent pas être enregistrées pour le prochain démarrage. {0}</translation></message>
    <message><source>Restore edits</source>
        <translation>Restaurer les modifications</translation></message>
    <message><source>Edits of this board</source>
        <translation>Modifications de cette carte</translation></message>
    <message><source>Name</source>
        <translation>Nom</translation></message>
    <message><source>Note</source>
        <translation>Note</translation></message>
    <message><source>Before</source>
        <translation>Avant</translation></message>
    <message><source>Board</source>
        <translation>Carte</translation></message>
    <message><source>No.</source>
        <translation>N°</translation></message>
    <message><source>damaged</source>
        <translation>endommagé</translation></message>
    <message><source>today {0}</source>
        <translation>aujourd'hui {0}</translation></message>
    <message><source>yesterday {0}</source>
        <translation>hier {0}</translation></message>
    <message><source>This snapshot is damaged and cannot be restored. {0}</source>
        <translation>Cet instantané est endommagé et ne peut pas être restauré. {0}</translation></message>
    <message><source>The board accepts changes in serial mode only: switch the board off, remove the mode jumper, and switch the board on. Your edits are kept.</source>
        <translation>La carte n'accepte des modifications qu'en mode série : coupez son alimentation, retirez le cavalier de mode, remettez l'alimentation. Les modifications sont conservées.</translation></message>
    <message><source>Nothing was written because no snapshot could be saved first. {0}</source>
        <translation>Rien n'a été écrit, car aucun instantané n'a pu être enregistré au préalable. {0}</translation></message>
    <message><source>Nothing was written: without a device number, the write would reach every board on this line. Select a board first.</source>
        <translation>Rien n'a été écrit : sans numéro d'appareil, cela atteindrait plusieurs cartes. Sélectionnez l'une des cartes de cette liaison.</translation></message>
    <message><source>Nothing else was written. {0}</source>
        <translation>Rien d'autre n'a été écrit. {0}</translation></message>
    <message numerus="yes"><source>Apply of %n setting(s)</source>
        <translation><numerusform>Application de %n réglage</numerusform><numerusform>Application de %n réglages</numerusform></translation></message>
    <message><source>{0} set</source>
        <translation>{0} : réglé</translation></message>
    <message><source>Joint mode: both outputs drive one motor, so there is nothing to identify.</source>
        <translation>Mode jumelé : les deux sorties alimentent un seul moteur, il n'y a donc rien à identifier.</translation></message>
    <message><source>Lift the robot so that its wheels turn freely, then confirm this here.</source>
        <translation>Soulevez le robot pour que ses roues tournent librement, puis confirmez-le ici.</translation></message>
    <message><source>The wheels may touch the ground.</source>
        <translation>Les roues touchent peut-être le sol.</translation></message>
    <message><source>The assistant was closed.</source>
        <translation>L'assistant a été fermé.</translation></message>
    <message><source>Another step of the assistant was opened.</source>
        <translation>Une autre étape de l'assistant a été ouverte.</translation></message>
    <message><source>Set up my robot</source>
        <translation>Configurer mon robot</translation></message>
    <message><source>Speed setpoint {0}</source>
        <translation>Consigne de vitesse {0}</translation></message>
    <message><source>Channel {0}</source>
        <translation>Voie {0}</translation></message>
    <message><source>{0} channel {1}</source>
        <translation>voie {1} ({0})</translation></message>
    <message><source>expected a number of counts (3750) or a value with a unit (1500us, 2.5V), not {0}</source>
        <translation>ce sont des counts (3750), ou une valeur comme 1500us ou 2.5V, et non {0}</translation></message>
    <message><source>minimum {0} is above neutral {1}</source>
        <translation>le minimum {0} est au-dessus du neutre {1}</translation></message>
    <message><source>neutral {0} is above maximum {1}</source>
        <translation>le neutre {0} est au-dessus du maximum {1}</translation></message>
    <message><source>minimum and maximum are both {0}; they must differ</source>
        <translation>le minimum et le maximum valent tous deux {0} ; ils doivent être différents</translation></message>
    <message><source>{0} is {1}; a calibration value must be 0 to {2}</source>
        <translation>{0} vaut {1} ; une valeur d'étalonnage va de 0 à {2}</translation></message>
    <message><source>calibration: {0}</source>
        <translation>étalonnage : {0}</translation></message>
    <message><source>a channel mask must be 0 to {0}, not {1}</source>
        <translation>un masque de voies va de 0 à {0}, et non {1}</translation></message>
    <message><source>parameter number</source>
        <translation>numéro de paramètre</translation></message>
    <message><source>{0:#04x} is not a TReX mode (R, A, r or a)</source>
        <translation>{0:#04x} n'est pas un mode du TReX (R, A, r ou a)</translation></message>
    <message><source>the request came back instead of a status</source>
        <translation>la requête est revenue à la place d'un état</translation></message>
    <message><source>the motor number must be 1 or 2, not {0}</source>
        <translation>les moteurs portent les numéros 1 et 2, et non {0}</translation></message>
    <message><source>{0} is not the signature of a TReX</source>
        <translation>{0} n'est pas la signature d'un TReX</translation></message>
    <message><source>a write must end in 55 2A, not {0}</source>
        <translation>une écriture se termine par 55 2A, et non {0}</translation></message>
    <message><source>speed of the auxiliary motor</source>
        <translation>vitesse du moteur auxiliaire</translation></message>
    <message><source>the channel number must be 1 to 5, not {0}</source>
        <translation>les voies sont numérotées de 1 à 5, et non {0}</translation></message>
    <message><source>the control flag must be 0 or 1, not {0}</source>
        <translation>0 ou 1 indique qui commande les moteurs, et non {0}</translation></message>
    <message><source>{0:#04x} names channels that a TReX does not have</source>
        <translation>{0:#04x} désigne des voies qu'un TReX n'a pas</translation></message>
    <message><source>a parameter number must be 0 to 127, not {0}</source>
        <translation>un paramètre va de 0 à 127, et non {0}</translation></message>
    <message><source>{0} is not a TReX result code (0 to 3)</source>
        <translation>{0} n'est pas un code de résultat du TReX (0 à 3)</translation></message>
    <message><source>parameter value</source>
        <translation>valeur de paramètre</translation></message>
    <message><source>device number</source>
        <translation>numéro d'appareil</translation></message>
    <message><source>Boards that are driven together need different device numbers.</source>
        <translation>Des cartes conduites ensemble ont besoin de numéros différents.</translation></message>
    <message><source>The board needs a device number that no other device on the line has.</source>
        <translation>Il faut à la carte un numéro qu'aucun autre appareil n'a.</translation></message>
    <message><source>{0!r} are not valid board settings</source>
        <translation>{0!r} ne correspond pas aux réglages d'une carte</translation></message>
    <message><source>Measured currents may be off by 20 % (twin).</source>
        <translation>La carte peut se tromper de 20 % en mesurant les courants (jumeau).</translation></message>
    <message><source>The stop is not confirmed. If a motor is still turning, cut its power.</source>
        <translation>L'arrêt n'est pas confirmé. Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>The stop was sent, but has no effect yet: the channels control the motors until channel 5 gives control to serial commands. Release the sticks, or cut the power.</source>
        <translation>L'ordre d'arrêt a été envoyé, mais les voies commandent les moteurs : il n'agit que lorsque la voie 5 donne la main aux commandes série. Relâchez les manches ou coupez l'alimentation.</translation></message>
    <message><source>minimum</source>
        <translation>minimum</translation></message>
    <message><source>neutral</source>
        <translation>neutre</translation></message>
    <message><source>maximum</source>
        <translation>maximum</translation></message>
    <message><source>deadband</source>
        <translation>zone morte</translation></message>
    <message><source>get signature</source>
        <translation>lire la signature</translation></message>
    <message><source>get mode</source>
        <translation>lire le mode</translation></message>
    <message><source>get serial control flag</source>
        <translation>lire si la liaison série commande les moteurs</translation></message>
    <message><source>get and clear status bits</source>
        <translation>lire les bits d'état et les effacer</translation></message>
    <message><source>get and clear UART error bits</source>
        <translation>lire les bits d'erreur UART et les effacer</translation></message>
    <message><source>get currents of both motors</source>
        <translation>lire les courants des deux moteurs</translation></message>
    <message><source>get channels with a changed calibration</source>
        <translation>lire quels étalonnages diffèrent de la valeur par défaut</translation></message>
    <message><source>null command (no effect)</source>
        <translation>commande vide : rien</translation></message>
    <message><source>RC mode</source>
        <translation>mode RC</translation></message>
    <message><source>analog mode</source>
        <translation>mode analogique</translation></message>
    <message><source>serial mode, RC inputs</source>
        <translation>mode série, entrées RC</translation></message>
    <message><source>serial mode, analog inputs</source>
        <translation>mode série, entrées analogiques</translation></message>
    <message><source>rejected: no such parameter (code 1)</source>
        <translation>rejeté : paramètre inexistant (code 1)</translation></message>
    <message><source>rejected: this value is not allowed (code 2)</source>
        <translation>rejeté : valeur non autorisée (code 2)</translation></message>
    <message><source>rejected: not in serial mode (code 3)</source>
        <translation>rejeté : pas en mode série (code 3)</translation></message>
    <message><source>RC mode: a radio receiver drives the motors.</source>
        <translation>Mode RC : un récepteur radio commande les moteurs.</translation></message>
    <message><source>Analog mode: voltages (joysticks, potentiometers) drive the motors.</source>
        <translation>Mode analogique : des tensions (joysticks, potentiomètres) commandent les moteurs.</translation></message>
    <message><source>Serial mode, with inputs read as RC pulses.</source>
        <translation>Mode série, entrées lues comme impulsions RC.</translation></message>
    <message><source>Serial mode, with inputs read as voltages.</source>
        <translation>Mode série, entrées lues comme tensions.</translation></message>
    <message><source>motor 1 (mixed: turn)</source>
        <translation>moteur 1 (avec mixage : rotation)</translation></message>
    <message><source>motor 2 (mixed: forward)</source>
        <translation>moteur 2 (avec mixage : avance)</translation></message>
    <message><source>auxiliary motor</source>
        <translation>moteur auxiliaire</translation></message>
    <message><source>flip switch</source>
        <translation>interrupteur de retournement</translation></message>
    <message><source>serial override switch</source>
        <translation>interrupteur de priorité série</translation></message>
    <message><source>Serial commands control the motors (serial mode).</source>
        <translation>Les commandes série commandent les moteurs (mode série).</translation></message>
    <message><source> Joint mode: both drivers work together as motor 1, and commands for motor 2 are ignored.</source>
        <translation> Mode jumelé : les deux drivers travaillent ensemble comme moteur 1, les commandes du moteur 2 sont ignorées.</translation></message>
    <message><source>accelerate</source>
        <translation>accélérer</translation></message>
    <message><source>set</source>
        <translation>régler immédiatement</translation></message>
    <message><source>no TReX</source>
        <translation>aucun TReX</translation></message>
    <message><source>set calibration of channel {0}: {1}</source>
        <translation>régler l'étalonnage de la voie {0} : {1}</translation></message>
    <message><source>{0} motor 1 to {1}, motor 2 to {2}</source>
        <translation>{0} le moteur 1 : {1}, le moteur 2 : {2}</translation></message>
    <message><source>Serial commands control the motors: channel 5 overrides the other inputs.</source>
        <translation>Les commandes série commandent les moteurs : la voie 5 leur donne la priorité sur les autres entrées.</translation></message>
    <message><source>motor {0}: {1:.2f} A</source>
        <translation>moteur {0} : {1:.2f} A</translation></message>
    <message><source>all channels</source>
        <translation>toutes les voies</translation></message>
    <message><source>no channel</source>
        <translation>aucune voie</translation></message>
    <message><source>parameter {0:#04x}, which {1} has</source>
        <translation>paramètre {0:#04x}, qu'{1} ne possède</translation></message>
    <message><source>yes</source>
        <translation>oui</translation></message>
    <message><source>no</source>
        <translation>non</translation></message>
    <message><source>motor {0}: {1} counts</source>
        <translation>moteur {0} : {1} counts</translation></message>
    <message><source>no {0}</source>
        <translation>aucun {0}</translation></message>
    <message><source>get raw inputs of {0}</source>
        <translation>lire les entrées brutes : {0}</translation></message>
    <message><source>get remapped inputs of {0}</source>
        <translation>lire les entrées converties : {0}</translation></message>
    <message><source>get current of motor {0}</source>
        <translation>lire le courant du moteur {0}</translation></message>
    <message><source>get calibration of channel {0}</source>
        <translation>lire l'étalonnage de la voie {0}</translation></message>
    <message><source>get {0}</source>
        <translation>lire {0}</translation></message>
    <message><source>set {0} to {1}</source>
        <translation>régler {0} à {1}</translation></message>
    <message><source>{0} motor {1} to {2}</source>
        <translation>{0} le moteur {1} : {2}</translation></message>
    <message><source>{0} auxiliary motor to {1}</source>
        <translation>{0} le moteur auxiliaire : {1}</translation></message>
    <message><source>The {0} channels control the motors. Serial commands take effect only when channel 5 gives control to them. For serial mode, switch the board off, remove the mode jumper and switch the board on again.</source>
        <translation>Les voies ({0}) commandent les moteurs. Les commandes série n'agissent que lorsque la voie 5 leur donne la main ; pour le mode série, coupez l'alimentation de la carte, retirez le cavalier de mode et remettez l'alimentation.</translation></message>
    <message><source>analog</source>
        <translation>analogique</translation></message>
    <message><source>brake with {0}</source>
        <translation>freiner à {0}</translation></message>
    <message><source>the PWM prescaler must be 0 to {0}, not {1}</source>
        <translation>le prédiviseur PWM va de 0 à {0}, et non {1}</translation></message>
    <message><source>the model must be {0}, not {1!r}</source>
        <translation>les modèles sont {0}, et non {1!r}</translation></message>
    <message><source>brake duty</source>
        <translation>taux de freinage</translation></message>
    <message><source>a motor's speed must be -127 to 127, not {0}</source>
        <translation>la vitesse d'un moteur va de -127 à 127, et non {0}</translation></message>
    <message><source>No TReX responds on {0}. Check that the board has power (an LED is lit), that the adapter's TX goes to SI and its RX to SO (an RS-232 adapter: to the RS-232 pins), that ground is connected, and that the serial settings match those of the board. If both LEDs blink together, the board is in learning mode: remove the SO–G jumper, then switch the board off and on.</source>
        <translation>Aucun TReX ne répond sur {0}. Vérifiez que la carte est alimentée (une LED est allumée), que TX de l'adaptateur va à SI et son RX à SO (ou aux deux broches RS-232, sans jamais mélanger), que la masse est reliée et que les réglages série de la carte sont bien ceux-ci. Si les deux LED clignotent ensemble, la carte est en mode apprentissage : retirez le cavalier SO–G, puis coupez et remettez l'alimentation.</translation></message>
    <message><source>Everything sent on {0} comes back, and nothing else arrives. Either this is the RS-232 side of a board that is off or set to another baud rate, or the adapter's TX and RX are joined.</source>
        <translation>Tout ce qui est envoyé sur {0} revient, et rien d'autre. Soit il s'agit du côté RS-232 d'une carte hors tension ou réglée sur un autre débit, soit TX et RX de l'adaptateur sont reliés entre eux.</translation></message>
    <message><source>Something responds on {0}, but not like a TReX. {1} Usually the baud rate, parity or CRC differs from the board's setting, or another device is connected.</source>
        <translation>Quelque chose répond sur {0}, mais pas comme un TReX. {1} En général, le débit, la parité ou le CRC diffère du réglage de la carte, ou un autre appareil est connecté.</translation></message>
    <message><source>The TReX on {0} is in its boot loader, waiting for new firmware. Check that the mix and SO–G jumpers are off, then switch the board off and on and connect again. Its serial settings may now be the factory defaults: 19200 baud, no parity, no CRC.</source>
        <translation>Le TReX sur {0} est dans son chargeur d'amorçage et attend un nouveau firmware. Vérifiez que les cavaliers Mix et SO–G sont retirés, puis coupez et remettez l'alimentation de la carte et connectez-vous à nouveau. Ses réglages série sont peut-être maintenant ceux d'usine : 19200 bauds, sans parité, sans CRC.</translation></message>
    <message><source>The device on {0} responds like a Pololu qik, not like a TReX. This program does not support it: select the port of the TReX, or connect the adapter to the TReX.</source>
        <translation>L'appareil sur {0} répond comme un qik de Pololu, pas comme un TReX. Ce programme ne le prend pas en charge : choisissez le port du TReX, ou branchez l'adaptateur sur le TReX.</translation></message>
    <message><source>Several boards reply at once on {0} at {1}. “Find” tries every device number. If two boards have the same number, switch one of them off and give the other board a different number.</source>
        <translation>Plusieurs cartes répondent en même temps sur {0} à {1}. « Rechercher… » interroge chaque numéro d'appareil ; si plusieurs cartes partagent le même, coupez l'alimentation de toutes sauf une et donnez à celle-ci son propre numéro.</translation></message>
    <message><source>A {1} responds on {0} at {2}, but this connection uses {3}. Connect with the settings of the board.</source>
        <translation>Un {1} répond sur {0} à {2}, mais cette connexion utilise {3}. Connectez-vous avec les réglages de la carte.</translation></message>
    <message><source>A {1} responds on {0} with CRC polynomial {2}, but this connection uses {3}. Connect with the settings of the board.</source>
        <translation>Un {1} répond sur {0} avec le polynôme CRC {2}, mais cette connexion utilise {3}. Connectez-vous avec les réglages de la carte.</translation></message>
    <message><source>A {1} responds on {0}, but its device number is {2}, and this connection uses {3}. Connect with the settings of the board.</source>
        <translation>Un {1} répond sur {0}, mais son numéro d'appareil est {2}, et cette connexion utilise {3}. Connectez-vous avec les réglages de la carte.</translation></message>
    <message><source>A {1} responds on {0}, but not every time: the line loses or corrupts bytes. Check the cable and the ground connection, keep motor leads away from the cable, then connect again.</source>
        <translation>Un {1} ne répond sur {0} que par moments : la liaison perd ou altère des octets. Vérifiez le câble et la masse, éloignez-en les fils des moteurs, puis connectez-vous à nouveau.</translation></message>
    <message><source>No reply to {0}.</source>
        <translation>Pas de réponse à {0}.</translation></message>
    <message><source>Incomplete reply to {0}: only {1} arrived.</source>
        <translation>Réponse incomplète à {0} : reçu {1} seulement.</translation></message>
    <message><source>The reply {0} is corrupted: {1}.</source>
        <translation>La réponse {0} est altérée : {1}.</translation></message>
    <message><source>Late replies arrived and cannot be matched to requests.</source>
        <translation>Des réponses tardives sont arrivées et ne peuvent pas être associées aux requêtes.</translation></message>
    <message><source>The board's replies to {0} differ each time: the line corrupts bytes, so the stored value is unknown. Check the cable and the ground connection, keep motor leads away from the cable, lower the baud rate, or use CRC.</source>
        <translation>Les réponses de la carte à {0} diffèrent à chaque fois : la liaison altère des octets, ce qui est enregistré n'est donc pas connu. Vérifiez le câble et la masse, éloignez-en les fils des moteurs, ou utilisez un débit plus bas ou le CRC.</translation></message>
    <message><source>The stop was sent, but the board does not confirm it. If a motor is still turning, cut its power.</source>
        <translation>L'ordre d'arrêt a été envoyé, mais la carte ne le confirme pas. Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>The stop was sent and the board responds, but the line corrupts bytes. The stop is repeated until the line is quiet. If a motor is still turning, cut its power.</source>
        <translation>L'ordre d'arrêt a été envoyé et la carte répond, mais la liaison altère des octets. Il est renvoyé jusqu'à ce que la liaison soit calme. Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>The program did not respond for more than half a second.</source>
        <translation>Le programme n'a pas répondu pendant plus d'une demi-seconde.</translation></message>
    <message><source>The motors that were driven draw no current: the board may have restarted.</source>
        <translation>Les moteurs pilotés n'absorbent aucun courant : la carte a peut-être redémarré.</translation></message>
    <message><source>The guardian process ended, and another one could not be started.</source>
        <translation>Le processus gardien s'est terminé, et un autre n'a pas pu être démarré.</translation></message>
    <message><source>Nothing was sent, because these bytes may move a motor. Arm the motors first.</source>
        <translation>Ces octets peuvent faire tourner un moteur ; rien n'a été envoyé. Activez d'abord les moteurs.</translation></message>
    <message><source>Nothing was sent, because these bytes may move a motor of another board, which a stop on this connection does not reach. Use device number {0} in the packet, or connect with the compact protocol.</source>
        <translation>Ces octets peuvent faire tourner un moteur d'une autre carte, qu'un arrêt sur cette connexion n'atteint pas ; rien n'a été envoyé. Indiquez-y l'appareil {0} comme destinataire, ou connectez-vous avec le protocole compact.</translation></message>
    <message><source>Nothing was sent, because a stop was requested first.</source>
        <translation>Un arrêt est intervenu avant ; rien n'a été envoyé.</translation></message>
    <message><source>The program does not scan for other boards while motors are armed or may be moving. Stop the motors first.</source>
        <translation>Aucune autre carte n'est recherchée tant que des moteurs sont activés ou tournent peut-être encore. Arrêtez d'abord les moteurs.</translation></message>
    <message><source>Board {0} was not selected, because the current board has not confirmed its stop. If a motor is still turning, cut its power.</source>
        <translation>La carte {0} n'a pas été sélectionnée, car aucun arrêt de la carte actuelle n'est confirmé. Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>Board {0} was not selected, because it does not respond. Check that it has power. The previous board is still selected.</source>
        <translation>La carte {0} n'a pas été sélectionnée, car elle ne répond pas. Vérifiez qu'elle est alimentée. La carte sélectionnée auparavant le reste.</translation></message>
    <message><source>Another board on this line has the device number {0}. Select an unused number.</source>
        <translation>Une autre carte de cette liaison a le numéro d'appareil {0}. Choisissez un numéro libre.</translation></message>
    <message><source>Board {0} no longer follows the group: it stopped responding, was stopped, or restarted.</source>
        <translation>La carte {0} ne suit plus : elle s'est tue, a été arrêtée ou a redémarré.</translation></message>
    <message><source>Board {0} is not one of the boards that are driven together here.</source>
        <translation>La carte {0} n'est pas de celles qui sont conduites ensemble ici.</translation></message>
    <message><source>While boards are driven together, you cannot change a device number, select a board, or send a packet that stores a setting. Connect to this board alone.</source>
        <translation>Les cartes conduites ensemble gardent leurs numéros, aucune ne peut être choisie, et aucun paquet saisi ne peut rien enregistrer. Connectez-vous à cette carte seule.</translation></message>
    <message><source>Another user drives this board. Ask that user to hand over control.</source>
        <translation>Un autre utilisateur pilote cette carte. Demandez qu'il la cède.</translation></message>
    <message><source>You may watch this board and stop it, but not drive or change it.</source>
        <translation>Vous pouvez observer cette carte et l'arrêter, mais ni la piloter ni la modifier.</translation></message>
    <message><source>Only an owner may take over from another user.</source>
        <translation>Seul un propriétaire peut prendre la conduite à un autre utilisateur.</translation></message>
    <message><source>Control was handed over, or the heartbeat did not reach the robot.</source>
        <translation>Le pilotage a été cédé, ou le signe de vie n'a pas atteint le robot.</translation></message>
    <message><source>{0}: the board does not know this parameter (code 1); its firmware may be too old</source>
        <translation>{0} : la carte ne connaît pas ce paramètre (code 1) ; son firmware est peut-être trop ancien</translation></message>
    <message><source>{0}: the board rejects this value (code 2)</source>
        <translation>{0} : la carte rejette cette valeur (code 2)</translation></message>
    <message><source>{0}: the board is not in serial mode (code 3); switch it off, remove the mode jumper and switch it on again</source>
        <translation>{0} : la carte n'est pas en mode série (code 3) ; coupez l'alimentation, retirez le cavalier de mode, remettez l'alimentation</translation></message>
    <message><source>{0} could not be verified: wrote {1}, but read back {2}</source>
        <translation>{0} n'a pas pu être vérifié : valeur écrite {1}, mais la carte renvoie {2} à la relecture</translation></message>
    <message><source>{0} could not be verified: read back {1}</source>
        <translation>{0} n'a pas pu être vérifié : la carte renvoie {1} à la relecture</translation></message>
    <message><source>{0} is for {1} inputs, but the board now reads {2} inputs</source>
        <translation>{0} vaut pour les entrées {1}, mais la carte lit maintenant {2}</translation></message>
    <message><source>Another board responds now: {0}. Nothing was written to it.</source>
        <translation>Une autre carte répond maintenant : {0}. Rien n'y a été écrit.</translation></message>
    <message><source>Another board responds now: {0}. Settings may have been written to it. Compare it with its last snapshot.</source>
        <translation>Une autre carte répond maintenant : {0}. Des réglages y ont peut-être été écrits ; comparez-la à son dernier instantané.</translation></message>
    <message><source>The board no longer stores the settings that were read from it: it is another board, or its settings were changed in the meantime. Nothing was written.</source>
        <translation>La carte ne contient plus les réglages qui y ont été lus : c'est une autre carte, ou elle a été modifiée entre-temps. Rien n'a été écrit.</translation></message>
    <message><source>The line corrupted bytes while {0} was being written, and another setting may have been changed instead. Read the board again and compare it with the last snapshot. {1}</source>
        <translation>La liaison a altéré des octets pendant l'écriture de {0} ; un autre réglage a peut-être été modifié à la place. Relisez la carte et comparez-la au dernier instantané. {1}</translation></message>
    <message><source>{0} settings differ from the values that were read before, so none was restored: another board may be connected.</source>
        <translation>{0} réglages diffèrent de ce qui avait été lu ; aucun n'a donc été restauré : une autre carte est peut-être connectée.</translation></message>
    <message><source>The write was cancelled before this setting was written.</source>
        <translation>L'écriture a été annulée avant d'en arriver là.</translation></message>
    <message><source>{0} {1} may have been reset to the factory default: after a power cycle, the board would run at {2}</source>
        <translation>{0} « {1} » : retour possible à la valeur d'usine ; après avoir coupé et remis l'alimentation, la carte fonctionnerait à {2}</translation></message>
    <message><source>The board is not responding; scanning for it.</source>
        <translation>La carte ne répond pas ; recherche en cours.</translation></message>
    <message><source>Motor 2 over current limit</source>
        <translation>Moteur 2 au-dessus de la limite de courant</translation></message>
    <message><source>The current of motor 2 exceeded its limit, so the limiter reduced the speed of the motor.</source>
        <translation>Le courant du moteur 2 a dépassé sa limite et le limiteur a réduit sa vitesse.</translation></message>
    <message><source>Motor 2 fault</source>
        <translation>Défaut du moteur 2</translation></message>
    <message><source>The driver of motor 2 shut itself down because of overheating, a short circuit or low voltage.</source>
        <translation>Le driver du moteur 2 s'est coupé : surchauffe, court-circuit ou tension trop basse.</translation></message>
    <message><source>Motor 1 over current limit</source>
        <translation>Moteur 1 au-dessus de la limite de courant</translation></message>
    <message><source>The current of motor 1 exceeded its limit, so the limiter reduced the speed of the motor.</source>
        <translation>Le courant du moteur 1 a dépassé sa limite et le limiteur a réduit sa vitesse.</translation></message>
    <message><source>Motor 1 fault</source>
        <translation>Défaut du moteur 1</translation></message>
    <message><source>The driver of motor 1 shut itself down because of overheating, a short circuit or low voltage.</source>
        <translation>Le driver du moteur 1 s'est coupé : surchauffe, court-circuit ou tension trop basse.</translation></message>
    <message><source>UART error</source>
        <translation>Erreur UART</translation></message>
    <message><source>A serial error occurred; the UART error bits show which.</source>
        <translation>Une erreur série s'est produite ; les bits d'erreur UART indiquent laquelle.</translation></message>
    <message><source>Serial timeout</source>
        <translation>Délai série</translation></message>
    <message><source>No byte arrived within the Serial Timeout. The board should have stopped its motors.</source>
        <translation>Aucun octet n'est arrivé pendant le « Délai série ». La carte devrait avoir arrêté ses moteurs.</translation></message>
    <message><source>Format error</source>
        <translation>Erreur de format</translation></message>
    <message><source>A packet contained an unknown command, an unexpected command byte or an invalid data byte.</source>
        <translation>Un paquet contenait une commande inconnue, un octet de commande en son milieu ou un octet de données non valide.</translation></message>
    <message><source>CRC error</source>
        <translation>Erreur CRC</translation></message>
    <message><source>The CRC byte of a packet was wrong; the packet was discarded.</source>
        <translation>L'octet CRC d'un paquet était faux ; le paquet a été rejeté.</translation></message>
    <message><source>Framing error</source>
        <translation>Erreur de trame</translation></message>
    <message><source>A stop bit was missing: the baud rates differ, or the line is noisy.</source>
        <translation>Un bit d'arrêt manquait : les débits diffèrent, ou la liaison est bruitée.</translation></message>
    <message><source>Data overrun</source>
        <translation>Débordement de données</translation></message>
    <message><source>A byte arrived while the receive register was still full.</source>
        <translation>Un octet est arrivé alors que le registre de réception était encore plein.</translation></message>
    <message><source>Parity error</source>
        <translation>Erreur de parité</translation></message>
    <message><source>A byte had the wrong parity: the parity settings differ, or the line is noisy.</source>
        <translation>La parité d'un octet était fausse : les réglages de parité diffèrent, ou la liaison est bruitée.</translation></message>
    <message><source>Read buffer overrun</source>
        <translation>Débordement du tampon de lecture</translation></message>
    <message><source>More bytes arrived than the board can buffer: something is sending while the board replies.</source>
        <translation>Il est arrivé plus d'octets que la carte ne peut en mettre en tampon ; quelque chose émet pendant que la carte répond.</translation></message>
    <message><source>Send buffer overrun</source>
        <translation>Débordement du tampon d'émission</translation></message>
    <message><source>A reply was longer than the send buffer.</source>
        <translation>Une réponse était plus longue que le tampon d'émission.</translation></message>
    <message><source>{0} must be 0 to 127, not {1}</source>
        <translation>{0} va de 0 à 127, et non {1}</translation></message>
    <message><source>a CRC-7 polynomial must be 0x80 to 0xFF, not {0:#x}</source>
        <translation>un polynôme CRC-7 va de 0x80 à 0xFF, et non {0:#x}</translation></message>
    <message><source>a data byte outside a packet</source>
        <translation>un octet de données hors d'un paquet</translation></message>
    <message><source>1 byte</source>
        <translation>1 octet</translation></message>
    <message><source>the CRC is {0:02X}, not {1:02X}</source>
        <translation>le CRC est {0:02X}, et non {1:02X}</translation></message>
    <message><source>the packet is not complete</source>
        <translation>le paquet n'est pas complet</translation></message>
    <message><source>a command byte inside a packet</source>
        <translation>un octet de commande dans un paquet</translation></message>
    <message><source>{0:#04x} is not a TReX command</source>
        <translation>{0:#04x} n'est pas une commande du TReX</translation></message>
    <message><source>the echo should be {0}</source>
        <translation>l'écho devrait être {0}</translation></message>
    <message><source>{0} bytes</source>
        <translation>{0} octets</translation></message>
    <message><source>{0} more than the reply has</source>
        <translation>{0} de trop par rapport à la réponse</translation></message>
    <message><source>UART settings must be a wire value from 0 to 127, not {0}</source>
        <translation>les réglages UART sont une valeur transmise de 0 à 127, et non {0}</translation></message>
    <message><source>the number of stop bits must be 1 or 2, not {0}</source>
        <translation>1 ou 2 bits d'arrêt, et non {0}</translation></message>
    <message><source>UART settings {0:#04x} do not contain a valid baud rate</source>
        <translation>les réglages UART {0:#04x} ne désignent aucun débit</translation></message>
    <message><source>a TReX runs at {0} baud, not {1}</source>
        <translation>un TReX fonctionne à {0} bauds, et non {1}</translation></message>
    <message><source>(twin)</source>
        <translation>(jumeau)</translation></message>
    <message><source>(inferred)</source>
        <translation>(déduit)</translation></message>
    <message><source>none</source><comment>channels</comment>
        <translation>aucune</translation></message>
    <message><source>channel {0}</source>
        <translation>voie {0}</translation></message>
    <message><source>channels {0}</source>
        <translation>voies {0}</translation></message>
    <message><source>{0} {1} has no parameter {2!r}{3}</source>
        <translation>{0} {1} n'a pas de paramètre {2!r}{3}</translation></message>
    <message><source>{0} must be {1}, not {2}</source>
        <translation>{0} accepte {1}, et non {2}</translation></message>
    <message><source>none, or any of channels 1 to 5, such as 1, 3</source>
        <translation>aucune, une ou plusieurs des voies 1 à 5, par exemple 1, 3</translation></message>
    <message><source>any of 1 to 5</source>
        <translation>n'importe lesquelles de 1 à 5</translation></message>
    <message><source>baud, error detection, stop bits</source>
        <translation>débit, détection d'erreurs, bits d'arrêt</translation></message>
    <message><source>a baud rate, error detection and stop bits (low four bits 0 to 10)</source>
        <translation>un débit, une détection d'erreurs et des bits d'arrêt (quatre bits de poids faible de 0 à 10)</translation></message>
    <message><source>{0} to {1} (wire value {2} to {3})</source>
        <translation>{0} à {1} (valeur transmise : {2} à {3})</translation></message>
    <message><source>the table has no parameter {0!r}</source>
        <translation>la table n'a pas de paramètre {0!r}</translation></message>
    <message><source> or </source>
        <translation> ou </translation></message>
    <message><source>written as {0}, with a baud rate that the board supports</source>
        <translation>une valeur écrite comme {0}, avec un débit que la carte prend en charge</translation></message>
    <message><source>; did you mean {0}?</source>
        <translation> ; vouliez-vous dire {0} ?</translation></message>
    <message><source>{0} to {1} s to full speed, or {2}</source>
        <translation>{0} à {1} s jusqu'à la pleine vitesse, ou {2}</translation></message>
    <message><source>channels 1 to 5 (wire value 0 to {0})</source>
        <translation>voies 1 à 5 (valeur transmise : 0 à {0})</translation></message>
    <message><source>{0} (wire value {1} to {2})</source>
        <translation>{0} (valeur transmise : {1} à {2})</translation></message>
    <message><source>{0} s to full speed</source>
        <translation>{0} s jusqu'à la pleine vitesse</translation></message>
    <message><source>{0} bytes are too many: at most {1} can be sent at once.</source>
        <translation>{0} octets, c'est trop : {1} au plus sont envoyés à la fois.</translation></message>
    <message><source>Enter bytes in hexadecimal, such as 86 1F.</source>
        <translation>Quels octets ? Donnez-les en hexadécimal, par exemple 86 1F.</translation></message>
    <message><source>device {0}: {1}</source>
        <translation>appareil {0} : {1}</translation></message>
    <message><source>not a TReX packet: {0}</source>
        <translation>ce n'est pas un paquet TReX : {0}</translation></message>
    <message><source>“{0}” is not a sequence of hexadecimal bytes such as 86 1F.</source>
        <translation>« {0} » n'est pas une suite d'octets hexadécimaux comme 86 1F.</translation></message>
    <message><source>No board is served to this user at {0}:{1}. Check that `trexcmd serve` is running there. Also check the user in the address (trex://USER@…) and the secret (TREX_SECRET).</source>
        <translation>Aucune carte n'est servie à {0}:{1}, ou pas à cet utilisateur. Vérifiez que trexcmd serve y fonctionne, l'utilisateur dans l'adresse (trex://USER@…) et son secret (TREX_SECRET).</translation></message>
    <message><source>The server cannot listen at {0}: {1}</source>
        <translation>Impossible d'écouter à {0} : {1}</translation></message>
    <message><source>{0} serves no board named {1} to this user.</source>
        <translation>{0} ne sert aucune carte nommée {1} à cet utilisateur.</translation></message>
    <message><source>It did not respond.</source>
        <translation>Il n'a pas répondu.</translation></message>
    <message><source>Boards on the network need additional packages: install trex-gui[remote] with pip or pipx.</source>
        <translation>Les cartes du réseau demandent d'autres paquets : installez trex-gui[remote] avec pip ou pipx.</translation></message>
    <message><source>unsolicited bytes</source>
        <translation>octets non sollicités</translation></message>
    <message><source>unsolicited bytes; perhaps a late reply</source>
        <translation>octets non sollicités ; peut-être une réponse tardive</translation></message>
    <message><source>only the echo came back</source>
        <translation>seul son écho est revenu</translation></message>
    <message><source>corrupted: {0}</source>
        <translation>altéré : {0}</translation></message>
    <message><source>accepted values</source>
        <translation>valeurs acceptées</translation></message>
    <message><source>{0} is left out: {1} means {2} to a {3}, but {4} to a {5}.</source>
        <translation>{0} est omis : {1} signifie {2} pour un {3}, mais {4} pour un {5}.</translation></message>
    <message><source>1 parameter</source>
        <translation>1 paramètre</translation></message>
    <message><source>{0} parameters</source>
        <translation>{0} paramètres</translation></message>
    <message><source>{0} will change</source>
        <translation>{0} à modifier</translation></message>
    <message><source>{0} match</source>
        <translation>{0} identiques</translation></message>
    <message><source>1 calibration</source>
        <translation>1 étalonnage</translation></message>
    <message><source>{0} calibrations</source>
        <translation>{0} étalonnages</translation></message>
    <message><source>a {0} with firmware {1}</source>
        <translation>un {0} avec le firmware {1}</translation></message>
    <message><source>{0} ({1}) is left out: {2} does not have this setting.</source>
        <translation>{0} ({1}) est omis : {2} ne l'a pas.</translation></message>
    <message><source>Calibration of {0}</source>
        <translation>Étalonnage de la {0}</translation></message>
    <message><source>{0} cannot be carried over</source>
        <translation>{0} non repris</translation></message>
    <message><source>{0} note</source>
        <translation>note sur {0}</translation></message>
    <message><source>For a {0}: {1} carried over, {2} changed, {3} left out.</source>
        <translation>Pour un {0} : {1} repris, {2} modifiés, {3} omis.</translation></message>
    <message><source>Firmware {0} really runs at {1} baud when set to {2}.</source>
        <translation>Le firmware {0} fonctionne en réalité à {1} bauds quand il est réglé à {2}.</translation></message>
    <message><source>Rounded down to steps of {0}: {1} becomes {2}.</source>
        <translation>Arrondi vers le bas par pas de {0} : {1} devient {2}.</translation></message>
    <message><source>A {0} with firmware {1} does not have this setting.</source>
        <translation>Un {0} avec le firmware {1} ne l'a pas.</translation></message>
    <message><source>The maximum for a {0} is {1}.</source>
        <translation>Un {0} accepte au plus {1}.</translation></message>
    <message><source>The minimum for a {0} is {1}; 0 means off (twin).</source>
        <translation>Un {0} accepte au moins {1} ; 0 le désactive (jumeau).</translation></message>
    <message><source>The same value in steps of {0}: {1} becomes {2}.</source>
        <translation>La même valeur par pas de {0} : {1} devient {2}.</translation></message>
    <message><source>these are settings of a {0}</source>
        <translation>ce sont des réglages d'un {0}</translation></message>
    <message><source>the layout of this file cannot be changed in place; save the settings as a new file</source>
        <translation>ce fichier est écrit d'une façon qui ne permet pas de le modifier sur place ; enregistrez les réglages dans un nouveau fichier</translation></message>
    <message><source>{0} {1}: the number of snapshots to keep is unknown, so none is removed.</source>
        <translation>{0} {1} : le nombre d'instantanés à conserver n'est pas connu, aucun n'est donc supprimé.</translation></message>
    <message><source>It does not name its board.</source>
        <translation>Il n'indique pas de quelle carte il s'agit.</translation></message>
    <message><source>It is empty.</source>
        <translation>Il est vide.</translation></message>
    <message><source>it cannot be removed</source>
        <translation>impossible à supprimer</translation></message>
    <message><source>is damaged</source>
        <translation>est endommagé</translation></message>
    <message><source>A name cannot be a number like {0}, because numbers already identify snapshots.</source>
        <translation>{0} serait le numéro d'un instantané.</translation></message>
    <message><source>Another snapshot has the name {0}.</source>
        <translation>Un autre instantané s'appelle déjà {0}.</translation></message>
    <message><source>is missing</source>
        <translation>est absent</translation></message>
    <message><source>the limit must be 1 to 9999999 snapshots, not {0}</source>
        <translation>un historique conserve au moins un instantané, et non {0}</translation></message>
    <message><source>At most {0} characters are allowed.</source>
        <translation>{0} caractères au plus sont possibles.</translation></message>
    <message><source>cannot be read ({0})</source>
        <translation>est illisible ({0})</translation></message>
    <message><source>All {0} device numbers are already used in {1}.</source>
        <translation>Les {0} numéros d'appareil figurent tous dans {1}.</translation></message>
    <message><source>Another program has changed {0}. Nothing was saved. Start again to continue this record.</source>
        <translation>Un autre programme a modifié {0}. Rien n'a été enregistré. Recommencez pour le compléter.</translation></message>
    <message><source>{0} is not a record of boards. Select another file.</source>
        <translation>{0} n'est pas un registre de cartes. Choisissez un autre fichier.</translation></message>
    <message><source>{0} is damaged: {1}.</source>
        <translation>{0} est endommagé : {1}.</translation></message>
    <message><source>the last line has no line break; was the file cut short?</source>
        <translation>la dernière ligne n'a pas de fin ; le fichier a-t-il été tronqué ?</translation></message>
    <message><source>{count} more errors are not listed</source>
        <translation>{count} autres erreurs ne sont pas indiquées</translation></message>
    <message><source>there must be a name before the colon, not a list or a group</source>
        <translation>avant les deux-points, il faut un nom, pas une liste ni un groupe</translation></message>
    <message><source>was already given in line {first}</source>
        <translation>est déjà indiqué à la ligne {first}</translation></message>
    <message><source>{name} was already given in line {first}</source>
        <translation>{name} est déjà indiqué à la ligne {first}</translation></message>
    <message><source>the first setting must be {wanted}, but this file has no product</source>
        <translation>le premier réglage est {wanted} ; il manque dans ce fichier</translation></message>
    <message><source>must be the first setting of the file</source>
        <translation>doit être le premier réglage du fichier</translation></message>
    <message><source>must be {models}, not {given}; did you mean {model}?</source>
        <translation>{models}, et non {given} ; vouliez-vous dire {model} ?</translation></message>
    <message><source>must be {models}, not {given}; these are not settings of a TReX</source>
        <translation>{models}, et non {given} ; ce ne sont pas les réglages d'un TReX</translation></message>
    <message><source>must be a version such as {newest}, not {given}</source>
        <translation>une version telle que {newest}, et non {given}</translation></message>
    <message><source>versions {oldest} to {newest} are known, but {given} is not</source>
        <translation>les versions {oldest} à {newest} sont connues, {given} ne l'est pas</translation></message>
    <message><source>is a command to the board, not a setting</source>
        <translation>est une commande à la carte, pas un réglage</translation></message>
    <message><source>must be {allowed}, not {given}{hint}</source>
        <translation>{allowed}, et non {given}{hint}</translation></message>
    <message><source>should be {allowed}{grade}, not {given}; the board decides</source>
        <translation>{allowed}{grade}, et non {given} ; c'est la carte qui décide</translation></message>
    <message><source>a {product} has this setting only from firmware {since} on, but the file is for {firmware}</source>
        <translation>un {product} l'a à partir du firmware {since}, ces réglages sont pour {firmware}</translation></message>
    <message><source>a {product} does not have this setting in any firmware</source>
        <translation>un {product} ne l'a pas, quel que soit son firmware</translation></message>
    <message><source>there is no such setting{guess}</source>
        <translation>ce réglage n'existe pas{guess}</translation></message>
    <message><source>must be written as {layout}, not {given}</source>
        <translation>s'écrit {layout}, et non {given}</translation></message>
    <message><source>a calibration has no {field!r}{guess}</source>
        <translation>un étalonnage n'a pas de {field!r}{guess}</translation></message>
    <message><source>{field} must be 0 to {highest}, not {given}</source>
        <translation>{field} va de 0 à {highest}, et non {given}</translation></message>
    <message><source>{fields} is missing</source>
        <translation>{fields} manque</translation></message>
    <message><source>{fields} are missing</source>
        <translation>{fields} manquent</translation></message>
    <message><source>1 of {total} parameters is missing: {names}</source>
        <translation>1 paramètre sur {total} manque : {names}</translation></message>
    <message><source>{count} of {total} parameters are missing: {names}</source>
        <translation>{count} paramètres sur {total} manquent : {names}</translation></message>
    <message><source>nothing</source>
        <translation>rien</translation></message>
    <message><source>channels 1 to 5</source>
        <translation>voies 1 à 5</translation></message>
    <message><source>a list</source>
        <translation>une liste</translation></message>
    <message><source>a group of settings</source>
        <translation>un groupe de réglages</translation></message>
    <message><source>a block of text</source>
        <translation>un bloc de texte</translation></message>
    <message><source>; write {0}</source>
        <translation> ; écrivez {0}</translation></message>
    <message><source>; write {1} for {0}</source>
        <translation> ; {0} s'écrit {1}</translation></message>
    <message><source>{0}: {1} becomes {2}</source>
        <translation>{0} : {1} devient {2}</translation></message>
    <message><source>{0} in quotes</source>
        <translation>{0} entre guillemets</translation></message>
    <message><source>{name} is off while a computer drives the motors: if the cable or the computer fails, the motors keep running at their last setpoint.</source>
        <translation>{name} est désactivé alors qu'un ordinateur commande les moteurs : si le câble ou l'ordinateur tombe en panne, les moteurs continuent de tourner à leur dernière consigne.</translation></message>
    <message><source>Both required and ignored: {channels}. The signal controls nothing, but without the signal the motors may not run in RC mode (inferred).</source>
        <translation>À la fois requis et ignoré : {channels}. Le signal ne fait rien bouger, mais sans lui les moteurs risquent de ne pas tourner en mode RC (déduit).</translation></message>
    <message><source>The {end} of {channel}, {count}, is beyond {limit}, the last count that the board measures: full speed on that side is never reached.</source>
        <translation>Le {end} de la {channel}, {count}, est au-delà de {limit}, la dernière valeur en counts que la carte mesure : la pleine vitesse n'est jamais atteinte de ce côté.</translation></message>
    <message><source>After the next power cycle, the line settings of the board will be {new} instead of {now}. Programs that use the board must then use the new line settings.</source>
        <translation>Après la prochaine coupure et remise de l'alimentation, les réglages de liaison de la carte seront {new} ; ce sont actuellement {now}. Modifiez alors les programmes qui utilisent la carte.</translation></message>
    <message><source>Prescaler {0} gives {1}.</source>
        <translation>Le prédiviseur {0} donne {1}.</translation></message>
    <message><source>The deadband of {channel} reaches from neutral to its {ends}: there is nothing between standstill and full speed on that side.</source>
        <translation>La zone morte de la {channel} s'étend du neutre jusqu'au {ends} : il n'y a rien entre l'arrêt et la pleine vitesse de ce côté.</translation></message>
    <message><source>A {board} set to {baud} baud really runs at {real} baud; firmware {fixed_in} corrects this. Programs must use {real} baud.</source>
        <translation>Un {board} réglé à {baud} bauds fonctionne en réalité à {real} bauds ; le firmware {fixed_in} corrige cela. Les programmes doivent utiliser {real} bauds.</translation></message>
    <message><source>This computer's serial port does not support {baud} baud: after the next power cycle, the computer could no longer reach the board.</source>
        <translation>Le port série de cet ordinateur ne prend pas en charge {baud} bauds : après la prochaine coupure et remise de l'alimentation, il ne pourrait plus atteindre la carte.</translation></message>
    <message><source>{0} to {1}</source><comment>set a parameter</comment>
        <translation>{0} à {1}</translation></message>
    <message><source>Set {0}</source>
        <translation>Régler {0}</translation></message>
    <message><source>{0} and {1}</source>
        <translation>{0} et {1}</translation></message>
    <message><source>{timeout} of {seconds} may not stop the motors if the cable or the computer fails: {shutdown} is off (twin).</source>
        <translation>{timeout} de {seconds} n'arrête peut-être pas les moteurs si le câble ou l'ordinateur tombe en panne : {shutdown} est désactivé (jumeau).</translation></message>
    <message><source>No effect in joint mode: {limits}. In this mode the board measures no current, so the motor is not protected.</source>
        <translation>Sans effet en mode jumelé : {limits}. La carte ne mesure alors aucun courant, le moteur n'est donc pas protégé.</translation></message>
    <message><source>{limit} is {value}, but its proportionality constant P, which sets how strongly the limiter reacts, is 0. Therefore, the limit may have no effect (inferred).</source>
        <translation>{limit} vaut {value}, mais sa constante de proportionnalité P, c'est-à-dire la force de réaction du limiteur, est à 0. La limite peut alors rester sans effet (déduit).</translation></message>
    <message><source>{limit} is {value} and {ramp} is 0, so the speed changes at once. As soon as the current falls below the limit, the motor jumps back to its full target speed, so it may run in jerks (inferred).</source>
        <translation>{limit} vaut {value} et {ramp} est à 0, c'est-à-dire immédiat. Dès que le courant repasse sous la limite, le moteur revient d'un coup à sa pleine vitesse de consigne ; il peut donc tourner par à-coups (déduit).</translation></message>
    <message><source>The PWM of motor {motor} runs at {now} (inferred), but the motor driver of a {product} is rated for {highest}. Above this frequency, the driver gets hot.</source>
        <translation>Le PWM du moteur {motor} fonctionne à {now} (déduit), mais le driver de moteur d'un {product} est prévu pour {highest} ; au-delà, il chauffe.</translation></message>
    <message><source>{name} is {value} instead of the default {default}, but CRC-7 is not switched on: no packet is checked with it.</source>
        <translation>{name} vaut {value} au lieu de la valeur par défaut {default}, mais CRC-7 n'est pas activé : aucun paquet n'est vérifié avec.</translation></message>
    <message><source>With {value} as {name} the checksum of every packet is 0, so CRC-7 detects no errors at all.</source>
        <translation>Avec {value} pour {name}, la somme de contrôle de chaque paquet est 0 : CRC-7 ne détecte alors aucune erreur.</translation></message>
    <message><source>{0} with firmware {1}</source>
        <translation>{0} avec le firmware {1}</translation></message>
    <message><source>{0}, deadband {1}</source>
        <translation>{0}, zone morte {1}</translation></message>
    <message><source>beyond a limit{0}: the board decides</source>
        <translation>au-delà d'une limite{0} : la carte décide</translation></message>
    <message><source>a {0} has no {1}</source>
        <translation>un {0} n'a pas de {1}</translation></message>
    <message><source>settings are plain 'key: value' lines</source>
        <translation>les réglages sont de simples lignes « clé: valeur »</translation></message>
    <message><source>this is nested too deeply; {0}</source>
        <translation>l'imbrication est trop profonde ici ; {0}</translation></message>
    <message><source>there are no settings here; the first must be 'product: TReX'</source>
        <translation>il n'y a pas de réglages ici ; le premier est 'product: TReX'</translation></message>
    <message><source>these are not settings of a TReX, which begin with 'product: TReX'</source>
        <translation>ce ne sont pas les réglages d'un TReX, qui commencent par « product: TReX »</translation></message>
    <message><source>a tab indents this line; indent it with spaces</source>
        <translation>une tabulation indente cette ligne ; indentez-la avec des espaces</translation></message>
    <message><source>this is not a setting; {0}</source>
        <translation>ceci n'est pas un réglage ; {0}</translation></message>
    <message><source>the character U+{0:04X} is not allowed in a text file</source>
        <translation>le caractère U+{0:04X} n'a pas sa place dans un fichier texte</translation></message>
    <message><source>the text is incomplete or damaged here ({0}); {1}</source>
        <translation>le texte est incomplet ou endommagé ici ({0}) ; {1}</translation></message>
    <message><source>there must be an ordinary space after the colon</source>
        <translation>tapez une espace ordinaire après les deux-points</translation></message>
    <message><source>a second document begins here; a settings file has only one</source>
        <translation>un second document commence ici ; un fichier de réglages n'en contient qu'un</translation></message>
    <message><source>anchors (&amp; and *) are not allowed; {0}</source>
        <translation>les ancres (&amp; et *) ne sont pas autorisées ; {0}</translation></message>
    <message><source>tags (!) are not allowed; {0}</source>
        <translation>les tags (!) ne sont pas autorisés ; {0}</translation></message>
    <message><source>there are more settings here than any board has</source>
        <translation>il y a ici plus de réglages que n'en a aucune carte</translation></message>
    <message><source>this number cannot be read; {0}</source>
        <translation>ce nombre est illisible ; {0}</translation></message>
    <message><source>merge keys (&lt;&lt;) are not allowed; {0}</source>
        <translation>les clés de fusion (&lt;&lt;) ne sont pas autorisées ; {0}</translation></message>
    <message><source>From the first setpoint until braking.</source>
        <translation>De la première consigne jusqu'au freinage.</translation></message>
    <message><source>Runs the test while you hold the button with the mouse or the space bar</source>
        <translation>Effectue l'essai tant qu'il est maintenu, avec la souris ou la barre d'espace</translation></message>
    <message><source>Open a saved test</source>
        <translation>Ouvrir un essai enregistré</translation></message>
    <message><source>Bench tests (*.csv);;All files (*)</source>
        <translation>Essais au banc (*.csv);;Tous les fichiers (*)</translation></message>
    <message><source>{0:%H:%M:%S}, motor {1}: {2}</source>
        <translation>{0:%H:%M:%S}, moteur {1} : {2}</translation></message>
    <message><source>Test to compare with</source>
        <translation>Essai auquel comparer</translation></message>
    <message><source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation></message>
    <message><source>Sa&amp;ve…</source>
        <translation>Enre&amp;gistrer…</translation></message>
    <message><source>&amp;Close</source>
        <translation>&amp;Fermer</translation></message>
    <message><source>The window of the bench test was closed.</source>
        <translation>La fenêtre de l'essai au banc a été fermée.</translation></message>
    <message><source>{0} was not saved: {1}.</source>
        <translation>{0} n'a pas été enregistré : {1}.</translation></message>
    <message><source>{0} was not opened: {1}.</source>
        <translation>{0} n'a pas été ouvert : {1}.</translation></message>
    <message><source>Release to stop</source>
        <translation>Relâcher pour arrêter</translation></message>
    <message><source>Hold to run</source>
        <translation>Maintenir pour faire tourner</translation></message>
    <message><source>Motor {0} is running: {1:.1f} of {2:g} s.</source>
        <translation>Le moteur {0} tourne : {1:.1f} sur {2:g} s.</translation></message>
    <message><source>Armed. Hold the button to run the motor. The motor stops when you release the button.</source>
        <translation>Moteurs activés. Maintenez le bouton enfoncé : le moteur ne tourne que tant que vous le maintenez.</translation></message>
    <message><source>Peak current</source>
        <translation>Courant de crête</translation></message>
    <message><source>The highest reading.</source>
        <translation>La mesure la plus élevée.</translation></message>
    <message><source>Steady current</source>
        <translation>Courant établi</translation></message>
    <message><source>At the end of the first phase at constant speed.</source>
        <translation>À la fin de la première vitesse constante.</translation></message>
    <message><source>Mean current</source>
        <translation>Courant moyen</translation></message>
    <message><source>Charge</source>
        <translation>Charge</translation></message>
    <message><source>Setpoint to current</source>
        <translation>De la consigne au courant</translation></message>
    <message><source>Time until the first reading of at least two counts. It includes the delays of the line, the board and the measurement.</source>
        <translation>Jusqu'à la première mesure de deux counts : la liaison, la carte et sa mesure.</translation></message>
    <message><source>Time until the current stayed within this percentage of the steady current, or within two counts of the steady current.</source>
        <translation>Jusqu'à ce que le courant ne s'écarte plus du courant établi de plus de cette proportion, ou de plus de deux counts.</translation></message>
    <message><source>&amp;Bench test…</source>
        <translation>Essai au &amp;banc…</translation></message>
    <message><source>Compar&amp;e with</source>
        <translation>&amp;Comparer avec</translation></message>
    <message><source>Save bench test</source>
        <translation>Enregistrer l'essai au banc</translation></message>
    <message><source>Open bench test</source>
        <translation>Ouvrir un essai au banc</translation></message>
    <message><source>Aborted after {0:.2f} s: {1}</source>
        <translation>Interrompu après {0:.2f} s : {1}</translation></message>
    <message><source>Released after {0:.2f} s.</source>
        <translation>Relâché après {0:.2f} s.</translation></message>
    <message><source>The test is complete.</source>
        <translation>L'essai est terminé.</translation></message>
    <message><source>the previous test</source>
        <translation>l'essai précédent</translation></message>
    <message><source>Figures of the test</source>
        <translation>Résultats de l'essai</translation></message>
    <message><source>This test</source>
        <translation>Cet essai</translation></message>
    <message><source>Compared</source>
        <translation>Comparé</translation></message>
    <message><source>Change</source>
        <translation>Écart</translation></message>
    <message><source>Saved as {0}.</source>
        <translation>Enregistré sous {0}.</translation></message>
    <message><source>Settled within {0:.0f} % after</source>
        <translation>Stabilisé à ±{0:.0f} % après</translation></message>
    <message><source>“Accelerate” uses the board's acceleration, brake duration and current limit. “Set at once” bypasses the acceleration and the brake duration, and briefly the current limit.</source>
        <translation>« Accélérer » utilise l'accélération, la durée de freinage et la limite de courant de la carte ; « Régler immédiatement » contourne les deux premières et aussi, pendant un instant, la limite.</translation></message>
    <message><source>A single reading above this current stops and disarms all motors. A motor draws the most current when it starts.</source>
        <translation>Une seule mesure au-dessus arrête et désactive tous les moteurs. C'est au démarrage qu'un moteur consomme le plus.</translation></message>
    <message><source>Abort also at the board's current &amp;limit</source>
        <translation>Interrompre aussi à la &amp;limite de la carte</translation></message>
    <message><source>Stop when the board reports that its own current limit was exceeded.</source>
        <translation>Arrêter quand la carte signale que sa propre limite de courant a été dépassée.</translation></message>
    <message><source>1 to {0}, full speed</source>
        <translation>1 à {0}, pleine vitesse</translation></message>
    <message><source>Connect to a board to see its settings.</source>
        <translation>Connectez une carte pour voir ses réglages.</translation></message>
    <message><source>Test</source>
        <translation>Essai</translation></message>
    <message><source>&amp;Motor</source>
        <translation>&amp;Moteur</translation></message>
    <message><source>Pro&amp;file</source>
        <translation>P&amp;rofil</translation></message>
    <message><source>Direc&amp;tion</source>
        <translation>Sen&amp;s</translation></message>
    <message><source>&amp;Duration</source>
        <translation>&amp;Durée</translation></message>
    <message><source>Se&amp;nt as</source>
        <translation>&amp;Envoi</translation></message>
    <message><source>Abort &amp;above</source>
        <translation>&amp;Interrompre au-dessus de</translation></message>
    <message><source>1 to {0}, the speed ceiling of the Motors page</source>
        <translation>1 à {0}, la vitesse maximale de la page Moteurs</translation></message>
    <message><source>R&amp;ises in</source>
        <translation>Monte e&amp;n</translation></message>
    <message><source>&amp;Period</source>
        <translation>&amp;Période</translation></message>
    <message><source>Appl&amp;y…</source>
        <translation>Appli&amp;quer…</translation></message>
    <message><source>Review and write all pending edits, including these</source>
        <translation>Vérifier et écrire toutes les modifications en attente, y compris celles-ci</translation></message>
    <message><source> s</source>
        <translation> s</translation></message>
    <message><source>Step: at once</source>
        <translation>Échelon : immédiat</translation></message>
    <message><source>Ramp: rising linearly</source>
        <translation>Rampe : montée linéaire</translation></message>
    <message><source>Reverse: back and forth</source>
        <translation>Inversion : aller et retour</translation></message>
    <message><source>Sine</source>
        <translation>Sinus</translation></message>
    <message><source>Forward</source>
        <translation>Avant</translation></message>
    <message><source>Reverse</source>
        <translation>Arrière</translation></message>
    <message><source>Accelerate</source>
        <translation>Accélérer</translation></message>
    <message><source> A</source>
        <translation> A</translation></message>
    <message><source>Limit P</source>
        <translation>Limite P</translation></message>
    <message><source>Se&amp;t at once</source>
        <translation>&amp;Régler immédiatement</translation></message>
    <message><source>Settings of motor {0}</source>
        <translation>Réglages du moteur {0}</translation></message>
    <message><source>Not applied: {0}</source>
        <translation>Non appliqué : {0}</translation></message>
    <message><source>{0} (stored: {1})</source>
        <translation>{0} (enregistré : {1})</translation></message>
    <message><source>The table contains the results as numbers.</source>
        <translation>Le tableau des valeurs donne les résultats en chiffres.</translation></message>
    <message><source>Speed setpoint against time</source>
        <translation>Consigne de vitesse, en fonction du temps</translation></message>
    <message><source>Motor current against time</source>
        <translation>Courant consommé, en fonction du temps</translation></message>
    <message><source>Setpoint</source>
        <translation>Consigne</translation></message>
    <message><source>Planned</source>
        <translation>Prévu</translation></message>
    <message><source>A</source>
        <translation>A</translation></message>
    <message><source>Abort {0:g} A</source>
        <translation>Interruption {0:g} A</translation></message>
    <message><source>Limit {0:g} A</source>
        <translation>Limite {0:g} A</translation></message>
    <message><source>put it on</source>
        <translation>à mettre</translation></message>
    <message><source>remove it</source>
        <translation>à retirer</translation></message>
    <message><source>Mode: off</source>
        <translation>Mode : retiré</translation></message>
    <message><source>Mix: on</source>
        <translation>Mixage : en place</translation></message>
    <message><source>Mix: off</source>
        <translation>Mixage : retiré</translation></message>
    <message><source>SO–G: on</source>
        <translation>SO–G : en place</translation></message>
    <message><source>SO–G: off</source>
        <translation>SO–G : retiré</translation></message>
    <message><source>Mode: {0}</source>
        <translation>Mode : {0}</translation></message>
    <message><source>sticks learned</source>
        <translation>manches appris</translation></message>
    <message><source>current limits</source>
        <translation>limites de courant</translation></message>
    <message><source>serial timeout</source>
        <translation>délai série</translation></message>
    <message><source>Set &amp;up my robot…</source>
        <translation>&amp;Configurer mon robot…</translation></message>
    <message><source>If the cable fails</source>
        <translation>Si le câble lâche</translation></message>
    <message><source>Sh&amp;ow them</source>
        <translation>Les m&amp;ontrer</translation></message>
    <message><source>The board</source>
        <translation>La carte</translation></message>
    <message><source>Prob&amp;lems</source>
        <translation>Prob&amp;lèmes</translation></message>
    <message><source>joint: one motor</source>
        <translation>jumelé : un seul moteur</translation></message>
    <message><source>RS-232 (everything sent comes back)</source>
        <translation>RS-232 (tout ce qui est envoyé revient)</translation></message>
    <message><source>this firmware runs at half this baud rate</source>
        <translation>ce micrologiciel fonctionne à la moitié de ce débit</translation></message>
    <message><source>None since {0}.</source>
        <translation>Aucun depuis {0}.</translation></message>
    <message><source>network {0:.0f} ms</source>
        <translation>réseau {0:.0f} ms</translation></message>
    <message><source>not known</source>
        <translation>inconnu</translation></message>
    <message><source>works with motor 1</source>
        <translation>marche avec le moteur 1</translation></message>
    <message><source>held by safe-start</source>
        <translation>retenu par le démarrage sûr</translation></message>
    <message><source>not armed</source>
        <translation>non activé</translation></message>
    <message><source>Mode jumper</source>
        <translation>Cavalier de mode</translation></message>
    <message><source>Mix jumper</source>
        <translation>Cavalier de mixage</translation></message>
    <message><source>SO–G jumper</source>
        <translation>Cavalier SO–G</translation></message>
    <message><source>Serial line</source>
        <translation>Ligne série</translation></message>
    <message><source>not responding</source>
        <translation>ne répond pas</translation></message>
    <message><source>replies arrive</source>
        <translation>les réponses arrivent</translation></message>
    <message><source>Red</source>
        <translation>Rouge</translation></message>
    <message><source>Green</source>
        <translation>Vert</translation></message>
    <message><source>unknown</source>
        <translation>inconnu</translation></message>
    <message><source>channels drive</source>
        <translation>les voies commandent</translation></message>
    <message><source>unknown: move a stick to find out</source>
        <translation>inconnu : bougez un manche</translation></message>
    <message><source>one stick drives both motors</source>
        <translation>un manche commande les deux moteurs</translation></message>
    <message><source>each channel drives one motor</source>
        <translation>chaque voie a son moteur</translation></message>
    <message><source>for RC and analog mode</source>
        <translation>pour les modes RC et analogique</translation></message>
    <message><source>flickers</source>
        <translation>scintille</translation></message>
    <message><source>{0:.0f} reads/s, {1:.1f} % answered</source>
        <translation>{0:.0f} lectures/s, {1:.1f} % répondues</translation></message>
    <message><source>CH{0}</source>
        <translation>V{0}</translation></message>
    <message><source>serial mode</source>
        <translation>mode série</translation></message>
    <message><source>RC</source>
        <translation>RC</translation></message>
    <message><source>Analog</source>
        <translation>Analogique</translation></message>
    <message><source>channel 5 selects serial</source>
        <translation>la voie 5 passe la main</translation></message>
    <message><source>Channel {0}: {1}</source>
        <translation>Voie {0} : {1}</translation></message>
    <message><source>{0} LED</source>
        <translation>LED {0}</translation></message>
    <message><source>may still turn</source>
        <translation>tourne peut-être encore</translation></message>
    <message><source>selected</source>
        <translation>sélectionnée</translation></message>
    <message><source>responding</source>
        <translation>répond</translation></message>
    <message><source>reply unreadable</source>
        <translation>réponse illisible</translation></message>
    <message><source>not scanned yet</source>
        <translation>pas encore interrogée</translation></message>
    <message><source>Click a board, or press Enter, to show it on every page. Motors stop first.</source>
        <translation>Cliquez sur une carte, ou appuyez sur Entrée, pour l'afficher sur toutes les pages. Les moteurs s'arrêtent d'abord.</translation></message>
    <message><source>Search for boards at all device numbers. No settings change</source>
        <translation>Demander pour chaque numéro d'appareil quelle carte le possède ; rien n'est modifié</translation></message>
    <message><source>Give the selected board another device number</source>
        <translation>Donner un autre numéro d'appareil à la carte sélectionnée</translation></message>
    <message><source>Drive several boards as one robot, with one pad and one Stop</source>
        <translation>Conduire plusieurs cartes comme un seul robot, avec une zone et un arrêt</translation></message>
    <message><source>Drive alone</source>
        <translation>Conduire seule</translation></message>
    <message><source>The line is first searched for the new number. If another board has this number, nothing is written. A board that is off or uses other serial settings cannot be found. If the number is free, a snapshot is saved and the new number is written. It takes effect at once.</source>
        <translation>Avant l'écriture, le nouveau numéro est demandé sur la liaison : si une autre carte le possède, rien n'est écrit. Une carte hors tension, ou qui a d'autres réglages série, ne peut pas être détectée. Le nouveau numéro prend effet immédiatement, et un instantané est enregistré d'abord.</translation></message>
    <message><source>Progress of the search</source>
        <translation>Progression de la recherche</translation></message>
    <message><source>Find boards</source>
        <translation>Rechercher des cartes</translation></message>
    <message><source>Cancel</source>
        <translation>Annuler</translation></message>
    <message><source>Change number…</source>
        <translation>Modifier le numéro…</translation></message>
    <message><source>Drive together…</source>
        <translation>Conduire ensemble…</translation></message>
    <message><source>Boards on this line</source>
        <translation>Cartes sur cette liaison</translation></message>
    <message><source>The board replied before. Check its power and its wires.</source>
        <translation>Elle a répondu auparavant. Vérifiez son alimentation et son câblage.</translation></message>
    <message><source>More than one board seems to have this number. Switch off all of them except one, and give that board a different number.</source>
        <translation>Plusieurs cartes semblent avoir ce numéro. Coupez l'alimentation de toutes sauf une, et donnez à celle-ci son propre numéro.</translation></message>
    <message><source>The board already has this number.</source>
        <translation>La carte a déjà ce numéro.</translation></message>
    <message><source>armed</source>
        <translation>moteurs activés</translation></message>
    <message><source>driven together</source>
        <translation>conduite ensemble</translation></message>
    <message><source>deselecting …</source>
        <translation>changement de carte …</translation></message>
    <message><source>selected, not responding</source>
        <translation>sélectionnée, ne répond pas</translation></message>
    <message><source>selected, armed</source>
        <translation>sélectionnée, moteurs activés</translation></message>
    <message><source>selected, may be moving</source>
        <translation>sélectionnée, peut-être en mouvement</translation></message>
    <message><source>&amp;New number:</source>
        <translation>Nouveau n&amp;uméro :</translation></message>
    <message><source>Change device nu&amp;mber…</source>
        <translation>Modifier le nu&amp;méro d'appareil…</translation></message>
    <message><source>&amp;Write number</source>
        <translation>Écrire le &amp;numéro</translation></message>
    <message><source>Taken: {0}.</source>
        <translation>Déjà pris : {0}.</translation></message>
    <message><source>Board now</source>
        <translation>Carte actuelle</translation></message>
    <message><source>After</source><comment>value</comment>
        <translation>Après</translation></message>
    <message><source>Nothing to write.</source>
        <translation>Rien à écrire.</translation></message>
    <message numerus="yes"><source>&amp;Write to %n board(s)</source>
        <translation><numerusform>Écrire &amp;dans %n carte</numerusform><numerusform>Écrire &amp;dans %n cartes</numerusform></translation></message>
    <message><source>&amp;Write to boards</source>
        <translation>Écrire &amp;dans les cartes</translation></message>
    <message><source>&amp;End after this board</source>
        <translation>&amp;Terminer après cette carte</translation></message>
    <message><source>This file cannot be used: it has errors. Nothing was changed.</source>
        <translation>Ce fichier est inutilisable : il contient des erreurs. Rien n'a été modifié.</translation></message>
    <message numerus="yes"><source>%n setting(s)</source>
        <translation><numerusform>%n réglage</numerusform><numerusform>%n réglages</numerusform></translation></message>
    <message><source>read, with warnings</source>
        <translation>lue, avec avertissements</translation></message>
    <message><source>read</source>
        <translation>lue</translation></message>
    <message><source>waiting</source>
        <translation>en attente</translation></message>
    <message><source>being read …</source>
        <translation>lecture …</translation></message>
    <message><source>being written …</source>
        <translation>écriture …</translation></message>
    <message><source>written and verified</source>
        <translation>écrite et vérifiée</translation></message>
    <message><source>not tried</source>
        <translation>non essayée</translation></message>
    <message><source>Changes</source>
        <translation>Modifications</translation></message>
    <message><source>The settings are written to the checked boards one after another. A snapshot of each board is saved first. Each board keeps its device number and its serial settings. Writing ends at the first write error.</source>
        <translation>Chaque carte cochée reçoit ces réglages, l'une après l'autre, avec un instantané au préalable. Chacune garde son numéro d'appareil et ses réglages série. La première erreur d'écriture met fin à l'opération.</translation></message>
    <message><source>Close</source>
        <translation>Fermer</translation></message>
    <message><source>Writing ended because Stop was pressed.</source>
        <translation>L'arrêt a été demandé, ce qui a mis fin à l'opération.</translation></message>
    <message numerus="yes"><source>Written to %n board(s).</source>
        <translation><numerusform>Écrit dans %n carte.</numerusform><numerusform>Écrit dans %n cartes.</numerusform></translation></message>
    <message><source>Apply {0} to several boards</source>
        <translation>Appliquer {0} à plusieurs cartes</translation></message>
    <message><source>File</source>
        <translation>Fichier</translation></message>
    <message numerus="yes"><source>%n board(s) left out; see the Result column.</source>
        <translation><numerusform>%n carte omise ; voir la colonne « Résultat ».</numerusform><numerusform>%n cartes omises ; voir la colonne « Résultat ».</numerusform></translation></message>
    <message><source>Board {0}</source>
        <translation>Carte {0}</translation></message>
    <message><source>{0}: beyond a limit that no document confirms (inferred). The board may reject the value or store a different value.</source>
        <translation>{0} : au-delà d'une limite qu'aucun document ne confirme (déduit). C'est la carte qui décide : elle peut rejeter la valeur, ou en enregistrer une autre.</translation></message>
    <message><source>Write an&amp;yway</source>
        <translation>Écrire &amp;quand même</translation></message>
    <message><source>{0}, firmware {1}</source>
        <translation>{0}, firmware {1}</translation></message>
    <message><source>The file is for a {0}, and the board is a {1}. Checked changes become edits.</source>
        <translation>Pour un {0} ; la carte est un {1}. Les changements cochés deviennent des modifications.</translation></message>
    <message numerus="yes"><source>{0}: %n change(s) pending. Review them, then write.</source>
        <translation><numerusform>{0} : %n modification en attente ; vérifiez-la pour l'écrire.</numerusform><numerusform>{0} : %n modifications en attente ; vérifiez-les pour les écrire.</numerusform></translation></message>
    <message><source>&amp;Edit the file instead</source>
        <translation>&amp;Modifier plutôt le fichier</translation></message>
    <message numerus="yes"><source>%n setting(s) differ, {0} match.</source>
        <translation><numerusform>%n réglage diffère, {0} identiques.</numerusform><numerusform>%n réglages diffèrent, {0} identiques.</numerusform></translation></message>
    <message><source>Opens the converted settings as a new file with the same comments. {0} is not changed.</source>
        <translation>Ouvre les réglages convertis dans un nouveau fichier, avec les commentaires de celui-ci. {0} reste inchangé.</translation></message>
    <message><source>&amp;Convert</source>
        <translation>&amp;Convertir</translation></message>
    <message><source>Load settings from {0}</source>
        <translation>Charger les réglages : {0}</translation></message>
    <message numerus="yes"><source>&amp;Load %n change(s)</source>
        <translation><numerusform>&amp;Charger %n modification</numerusform><numerusform>&amp;Charger %n modifications</numerusform></translation></message>
    <message numerus="yes"><source>&amp;Copy %n value(s) to {0}</source>
        <translation><numerusform>&amp;Copier %n valeur vers {0}</numerusform><numerusform>&amp;Copier %n valeurs vers {0}</numerusform></translation></message>
    <message><source>Convert &amp;for:</source>
        <translation>Convertir &amp;pour :</translation></message>
    <message><source>Board, as shown</source>
        <translation>Carte, telle qu'affichée</translation></message>
    <message><source>Not in the file and therefore unchanged: {0}.</source>
        <translation>Absents du fichier, donc inchangés : {0}.</translation></message>
    <message><source>Convert {0}</source>
        <translation>Convertir {0}</translation></message>
    <message><source>In the file</source>
        <translation>Dans le fichier</translation></message>
    <message><source>{0} was not loaded: the board is no longer connected.</source>
        <translation>{0} n'a pas été chargé : la carte n'est plus connectée.</translation></message>
    <message><source>Load {0}</source>
        <translation>Charger {0}</translation></message>
    <message><source>Copy values from {0}</source>
        <translation>Copier des valeurs depuis {0}</translation></message>
    <message numerus="yes"><source>%n value(s) copied from {0}.</source>
        <translation><numerusform>%n valeur copiée depuis {0}.</numerusform><numerusform>%n valeurs copiées depuis {0}.</numerusform></translation></message>
    <message><source>For a {0}</source>
        <translation>Pour un {0}</translation></message>
    <message><source>Resets every parameter with the board's own reset command when the board next starts</source>
        <translation>Réinitialise tous les paramètres par la commande de la carte, à son prochain démarrage</translation></message>
    <message><source>&amp;Let the board reset itself…</source>
        <translation>&amp;Laisser la carte se réinitialiser…</translation></message>
    <message><source>At its next start the board will reset every parameter, including the unchecked ones. The current settings of the board are saved first (File, History). Unapplied changes are discarded; Undo restores them.</source>
        <translation>À son prochain démarrage, la carte réinitialisera tous les paramètres, y compris ceux décochés ici. Ses réglages actuels sont d'abord sauvegardés (Fichier, Historique). Les modifications non appliquées sont abandonnées ; « Annuler » les restaure.</translation></message>
    <message><source>The board would get device number {0}, which another board on this line already has. Both would reply at the same time, and neither could be read. Give the other board a different number first.</source>
        <translation>Elle prendra le numéro d'appareil {0}, qu'une autre carte de cette liaison porte déjà : les deux répondraient en même temps et aucune ne serait lisible. Donnez d'abord un autre numéro à cette autre carte.</translation></message>
    <message numerus="yes"><source>Write %n setting(s) to the board</source>
        <translation><numerusform>Écrire %n réglage dans la carte</numerusform><numerusform>Écrire %n réglages dans la carte</numerusform></translation></message>
    <message><source>Writing. Leave the power on.</source>
        <translation>Écriture en cours. Ne coupez pas l'alimentation.</translation></message>
    <message><source>A snapshot of all settings is saved first. Each value is read back.</source>
        <translation>Un instantané de tous les réglages est enregistré d'abord. Chaque valeur est relue.</translation></message>
    <message><source>{0} (device number {1}, {2})</source>
        <translation>{0} (numéro d'appareil {1}, {2})</translation></message>
    <message><source>Progress of writing</source>
        <translation>Progression de l'écriture</translation></message>
    <message><source>Reset the &amp;board</source>
        <translation>Réinitialiser la &amp;carte</translation></message>
    <message><source>{0} of {1}: {2}</source>
        <translation>{0} sur {1} : {2}</translation></message>
    <message><source>{0} of {1} settings could not be verified and are still pending.</source>
        <translation>{0} sur {1} n'ont pas pu être vérifiés ; ils restent en attente.</translation></message>
    <message><source>The value that was being written when the connection was lost may be the old one, the new one or, after a power cut, the default. It will be read again.</source>
        <translation>La valeur en cours d'écriture au moment de la perte de connexion peut être l'ancienne, la nouvelle ou, après une coupure d'alimentation, la valeur par défaut. Elle sera relue.</translation></message>
    <message><source>Before</source><comment>value</comment>
        <translation>Avant</translation></message>
    <message numerus="yes"><source>%n setting(s) written and verified.</source>
        <translation><numerusform>%n réglage écrit et vérifié.</numerusform><numerusform>%n réglages écrits et vérifiés.</numerusform></translation></message>
    <message><source>Saving a snapshot. Nothing has been written yet.</source>
        <translation>Enregistrement d'un instantané. Rien n'est encore écrit.</translation></message>
    <message><source>No board is responding. The edits are kept.</source>
        <translation>Aucune carte ne répond. Les modifications sont conservées.</translation></message>
    <message><source>The board will reset itself at its next start, and values written now would be lost. Switch the board off and on first (Device, Make stored settings active).</source>
        <translation>La carte va se réinitialiser à son prochain démarrage et perdrait ce qui serait écrit maintenant. Coupez et remettez d'abord son alimentation (Appareil, Rendre actifs les réglages enregistrés).</translation></message>
    <message><source>These calibrations stay pending until the board uses their input source again: {0}.</source>
        <translation>Ces étalonnages restent en attente jusqu'à ce que la carte utilise de nouveau leur source des entrées : {0}.</translation></message>
    <message><source>Active only after the board is switched off and on: {0}.</source>
        <translation>Actif seulement après avoir coupé et remis l'alimentation de la carte : {0}.</translation></message>
    <message><source>Restore factor&amp;y defaults…</source>
        <translation>Restaurer les réglages d'&amp;usine…</translation></message>
    <message><source>Restore ser&amp;ial defaults…</source>
        <translation>Restaurer les réglages série par &amp;défaut…</translation></message>
    <message numerus="yes"><source>&amp;Write %n setting(s)</source>
        <translation><numerusform>Écrire %n &amp;réglage</numerusform><numerusform>Écrire %n &amp;réglages</numerusform></translation></message>
    <message><source>Channel calibrations are not changed.</source>
        <translation>Les étalonnages des voies restent.</translation></message>
    <message><source>The connection was lost.</source>
        <translation>La connexion a été perdue.</translation></message>
    <message><source>not attempted</source>
        <translation>non tenté</translation></message>
    <message><source>No source confirms these defaults: {0}.</source>
        <translation>Aucune source ne confirme la valeur par défaut de : {0}.</translation></message>
    <message><source>Both off</source>
        <translation>Les deux éteintes</translation></message>
    <message><source>No power</source>
        <translation>Pas d'alimentation</translation></message>
    <message><source>Check the supply and its leads. If only a blue LED is lit, the board has no firmware.</source>
        <translation>Vérifiez l'alimentation et ses fils. Si seule une LED bleue est allumée, la carte n'a pas de firmware.</translation></message>
    <message><source>Red on</source>
        <translation>Rouge allumée</translation></message>
    <message><source>Running: serial commands control the motors</source>
        <translation>En marche, les commandes série commandent les moteurs</translation></message>
    <message><source>Compare the wires with the picture, then search with “Find”. The green LED lights while the board receives a command. If it never lights, nothing arrives.</source>
        <translation>Comparez le câblage avec l'image, puis lancez « Rechercher… ». La LED verte s'allume pendant que la carte reçoit une commande : si elle ne s'allume jamais, rien n'arrive.</translation></message>
    <message><source>Green on, or flashing fast</source>
        <translation>Verte allumée, ou clignotant vite</translation></message>
    <message><source>Running: the channels control the motors</source>
        <translation>En marche, les voies commandent les moteurs</translation></message>
    <message><source>Proceed as above: the board also responds in RC and analog mode. The red LED lights while the board receives a command. Fast flashes mean safe-start. Five flashes at power-up show which channels are learned.</source>
        <translation>Comme ci-dessus : la carte répond aussi en mode RC et en mode analogique. La LED rouge s'allume pendant qu'elle reçoit une commande. Un clignotement rapide signale le démarrage sécurisé ; cinq éclats à la mise sous tension indiquent les voies apprises.</translation></message>
    <message><source>Both blink together, or both on</source>
        <translation>Les deux clignotent ensemble ou sont allumées</translation></message>
    <message><source>Learning mode</source>
        <translation>Mode apprentissage</translation></message>
    <message><source>The board does not respond while it learns its channels. Remove the SO–G jumper, then switch the board off and on.</source>
        <translation>La carte ne répond pas pendant qu'elle apprend ses voies. Retirez le cavalier SO–G, puis coupez et remettez l'alimentation.</translation></message>
    <message><source>Red and green alternate</source>
        <translation>Rouge et verte en alternance</translation></message>
    <message><source>Waiting for the boot loader handshake</source>
        <translation>Attente de la prise de contact du chargeur d'amorçage</translation></message>
    <message><source>Switch the board off, remove the mix and SO–G jumpers, and switch it on. If its serial settings are lost, continue with the handshake instead.</source>
        <translation>Coupez l'alimentation de la carte, retirez les cavaliers Mix et SO–G, et remettez l'alimentation. Ou poursuivez la prise de contact en cas de réglages série perdus.</translation></message>
    <message><source>Green flashes once a second</source>
        <translation>La verte clignote une fois par seconde</translation></message>
    <message><source>Boot loader, waiting for new firmware</source>
        <translation>Chargeur d'amorçage, en attente d'un nouveau firmware</translation></message>
    <message><source>Switch the board off and on, with the jumpers removed.</source>
        <translation>Coupez et remettez l'alimentation de la carte, cavaliers retirés.</translation></message>
    <message><source>The mode jumper may also be on: the board responds in every mode.</source>
        <translation>Le cavalier de mode peut aussi être en place : la carte répond dans tous les modes.</translation></message>
    <message><source>Jumpers</source>
        <translation>Cavaliers</translation></message>
    <message><source>Switch the board off. Remove the mode jumper. Put the mix and SO–G jumpers on.</source>
        <translation>Coupez l'alimentation de la carte. Retirez le cavalier de mode. Mettez les cavaliers Mix et SO–G.</translation></message>
    <message><source>Nothing: the board has no power.</source>
        <translation>Rien : la carte n'est pas alimentée.</translation></message>
    <message><source>Switch on</source>
        <translation>Mettre sous tension</translation></message>
    <message><source>Switch the board on.</source>
        <translation>Mettez la carte sous tension.</translation></message>
    <message><source>Red and green alternate, about once a second.</source>
        <translation>Rouge et verte en alternance, environ une fois par seconde.</translation></message>
    <message><source>Nothing: the SO–G jumper connects SO to ground.</source>
        <translation>Rien : le cavalier SO–G maintient sa ligne à la masse.</translation></message>
    <message><source>Remove the mix jumper. Leave the power on.</source>
        <translation>Retirez le cavalier Mix. Laissez l'alimentation en marche.</translation></message>
    <message><source>Red and green alternate, four times as fast.</source>
        <translation>Rouge et verte en alternance, quatre fois plus vite.</translation></message>
    <message><source>Remove the SO–G jumper. Leave the power on.</source>
        <translation>Retirez le cavalier SO–G. Laissez l'alimentation en marche.</translation></message>
    <message><source>The boot loader answers each byte with a question mark. The serial settings should now be the factory settings.</source>
        <translation>Le chargeur d'amorçage répond à chaque octet par un point d'interrogation. Les réglages série devraient maintenant être ceux d'usine.</translation></message>
    <message><source>Connect</source>
        <translation>Connecter</translation></message>
    <message><source>Switch the board off and on, with all three jumpers removed. Then connect at 19200 baud, without parity or CRC.</source>
        <translation>Coupez et remettez l'alimentation de la carte, les trois cavaliers retirés. Connectez-vous ensuite à 19200 bauds, sans parité ni CRC.</translation></message>
    <message><source>Five flashes, then red stays on.</source>
        <translation>Cinq clignotements, puis la rouge reste allumée.</translation></message>
    <message><source>The TReX responds at the factory settings.</source>
        <translation>Le TReX répond avec les réglages d'usine.</translation></message>
    <message><source>Restores the factory serial settings (inferred). If the LEDs alternate for only three seconds, start again.</source>
        <translation>Rétablit les réglages série d'usine (déduit). Si les LED n'alternent que pendant trois secondes, recommencez.</translation></message>
    <message><source>Connects at 19200 baud, without parity or CRC, to any device number</source>
        <translation>19200 bauds, sans parité ni CRC, quel que soit le numéro d'appareil</translation></message>
    <message><source>&amp;Connect at factory settings</source>
        <translation>&amp;Connecter avec les réglages d'usine</translation></message>
    <message><source>What the LEDs show</source>
        <translation>Ce que montrent les LED</translation></message>
    <message><source>Jumpers and LEDs</source>
        <translation>Cavaliers et LED</translation></message>
    <message><source>What this computer receives</source>
        <translation>Ce que reçoit cet ordinateur</translation></message>
    <message><source>&amp;Find now</source>
        <translation>Rec&amp;hercher maintenant</translation></message>
    <message><source>&amp;Board does not respond…</source>
        <translation>La carte ne &amp;répond pas…</translation></message>
    <message><source>LEDs</source>
        <translation>LED</translation></message>
    <message><source>&amp;Next</source>
        <translation>&amp;Suivant</translation></message>
    <message><source>Show wire values, and settings that match</source>
        <translation>Afficher les valeurs transmises et les réglages identiques</translation></message>
    <message><source>Select &amp;all</source>
        <translation>&amp;Tout sélectionner</translation></message>
    <message><source>Deta&amp;ils</source>
        <translation>Déta&amp;ils</translation></message>
    <message><source>Comparison of settings</source>
        <translation>Comparaison des réglages</translation></message>
    <message numerus="yes"><source>%n count(s)</source>
        <translation><numerusform>%n count</numerusform><numerusform>%n counts</numerusform></translation></message>
    <message><source>Enter 0 to {0}, such as 2.5 V, 2500 mV or 512 counts.</source>
        <translation>Entrez 0 à {0}, par exemple 2,5 V, 2500 mV ou 512 counts.</translation></message>
    <message><source>Not a value</source>
        <translation>Pas une valeur</translation></message>
    <message><source>{0} is not a valid value. {1}</source>
        <translation>{0} n'est pas une valeur valide. {1}</translation></message>
    <message><source>Enter 0 to {0}, such as 1500 µs, 1.5 ms or 3750 counts.</source>
        <translation>Entrez 0 à {0}, par exemple 1500 µs, 1,5 ms ou 3750 counts.</translation></message>
    <message><source>The nearest value that the board can store is {0}.</source>
        <translation>La valeur la plus proche que la carte peut enregistrer est {0}.</translation></message>
    <message><source>&amp;Turn</source>
        <translation>&amp;Rotation</translation></message>
    <message><source>&amp;Forward</source>
        <translation>&amp;Avancer</translation></message>
    <message><source>blink {0}/s</source>
        <translation>clignote {0}/s</translation></message>
    <message><source>alternate {0}/s</source>
        <translation>alterne {0}/s</translation></message>
    <message><source>short flash {0}/s</source>
        <translation>éclair bref {0}/s</translation></message>
    <message><source>The sticks control the motors.</source>
        <translation>Les manches commandent les moteurs.</translation></message>
    <message><source>Safe-start: the motors wait until the sticks are centred.</source>
        <translation>Démarrage sécurisé : les moteurs attendent que les manches soient centrés.</translation></message>
    <message><source>Switches the power off for a second. At power-up, the board reads its jumpers and activates the stored settings</source>
        <translation>Coupée une seconde : les cavaliers sont lus, les réglages enregistrés prennent effet</translation></message>
    <message><source>A weak battery sags when the motors start, and the board resets</source>
        <translation>La tension d'une batterie faible chute au démarrage des moteurs, et la carte redémarre</translation></message>
    <message><source>Hold all sticks centred, as safe-start requires</source>
        <translation>Maintenir tous les manches au centre, comme l'exige le démarrage sécurisé</translation></message>
    <message><source>The next byte reaches the board with this error, which the Problems page counts. Only a board with parity detects a parity error.</source>
        <translation>Le prochain octet arrive à la carte avec cette erreur ; « Problèmes » la compte. Seule une carte avec parité détecte une erreur de parité.</translation></message>
    <message><source>An error of the serial line that the board reports</source>
        <translation>Une erreur de la liaison série que la carte signale</translation></message>
    <message><source>The power is off: the board does not reply.</source>
        <translation>L'alimentation est coupée : la carte ne répond pas.</translation></message>
    <message><source>RC mode.</source>
        <translation>Mode RC.</translation></message>
    <message><source>Analog mode.</source>
        <translation>Mode analogique.</translation></message>
    <message><source>Safe-start: the motors wait for a signal on input {0}.</source>
        <translation>Démarrage sécurisé : les moteurs attendent un signal sur l'entrée {0}.</translation></message>
    <message><source>Safe-start: the motors wait until channel 5 no longer requests override.</source>
        <translation>Démarrage sécurisé : les moteurs attendent que la voie 5 ne demande plus la priorité.</translation></message>
    <message><source>Resets everything: stored settings, jumpers, sticks, loads and serial line faults</source>
        <translation>Réinitialise tout : réglages enregistrés, cavaliers, manches, charges et défauts de la liaison</translation></message>
    <message><source>Power on</source><comment>state</comment>
        <translation>Sous tension</translation></message>
    <message><source>The board's power switch</source>
        <translation>L'interrupteur d'alimentation de la carte</translation></message>
    <message><source>Power cycle</source>
        <translation>Couper et remettre</translation></message>
    <message><source>Battery</source>
        <translation>Batterie</translation></message>
    <message><source>Move automatically</source>
        <translation>Mouvement automatique</translation></message>
    <message><source>All sticks swing slowly. A stick that you move stays where you put it.</source>
        <translation>Tous les manches oscillent lentement ; en déplacer un l'immobilise</translation></message>
    <message><source>Centre</source>
        <translation>Centrer</translation></message>
    <message><source>Input {0}: {1}. Double-click to centre the stick, or press Delete to unplug the input.</source>
        <translation>Entrée {0} : {1}. Un double clic la centre, Suppr la débranche.</translation></message>
    <message><source>If the cable is unplugged, the port disappears. Serial Timeout and UART-Error Shutdown should then stop the motors</source>
        <translation>Débranché, le port disparaît : « Délai série » et « Arrêt sur erreur UART » devraient arrêter les moteurs</translation></message>
    <message><source>The mode jumper, which the board reads at power-up</source>
        <translation>Le cavalier de mode ; la carte le lit à la mise sous tension</translation></message>
    <message><source>The mix jumper: input 2 drives forward and input 1 turns. A change takes effect at once</source>
        <translation>Le cavalier Mix : l'entrée 2 fait avancer, l'entrée 1 fait tourner ; prend effet immédiatement</translation></message>
    <message><source>Connects SO to ground. If the mix jumper is also on, the board learns the calibration of its inputs at power-up</source>
        <translation>Relie SO à la masse ; avec Mix, une mise sous tension apprend alors l'étalonnage des entrées</translation></message>
    <message><source>Factory state</source>
        <translation>État d'usine</translation></message>
    <message><source>Mode is read at power-up; Mix takes effect at once.</source>
        <translation>Le mode est lu à la mise sous tension ; Mix prend effet immédiatement.</translation></message>
    <message><source>The wire from SO is broken: the board executes commands, but no reply arrives</source>
        <translation>Le fil de SO est coupé : la carte exécute les commandes, aucune réponse n'arrive</translation></message>
    <message><source>This percentage of the bytes in each direction is corrupted. CRC detects the errors</source>
        <translation>Cette proportion des octets est altérée dans chaque sens ; le CRC les détecte</translation></message>
    <message><source>Supply</source>
        <translation>Alimentation</translation></message>
    <message><source>Error in one byte</source>
        <translation>Erreur d'un octet</translation></message>
    <message><source>Corrupt one byte</source>
        <translation>Altérer un octet</translation></message>
    <message><source>Stick of input {0}</source>
        <translation>Manche de l'entrée {0}</translation></message>
    <message><source>plugged in</source>
        <translation>branché</translation></message>
    <message><source>unplugged</source>
        <translation>débranché</translation></message>
    <message><source>LEDs of the board</source>
        <translation>LED de la carte</translation></message>
    <message><source>Makes the driver of motor {0} shut down, as when it is hot or shorted</source>
        <translation>Le driver du moteur {0} se coupe, comme en cas de surchauffe ou de court-circuit</translation></message>
    <message><source>Load of motor {0}</source>
        <translation>Charge du moteur {0}</translation></message>
    <message><source>The current that motor {0} draws at full speed. At the right end of the slider, the motor stalls, which triggers current limits and faults</source>
        <translation>Le courant que consomme le moteur {0} à pleine vitesse ; à l'extrémité droite, il cale, ce qui déclenche limites de courant et défauts</translation></message>
    <message><source>Load</source>
        <translation>Charge</translation></message>
    <message><source>Overrun</source>
        <translation>Débordement</translation></message>
    <message><source>Input {0}</source>
        <translation>Entrée {0}</translation></message>
    <message><source>Plug of input {0}</source>
        <translation>Fiche de l'entrée {0}</translation></message>
    <message><source>Unplug input {0}: an RC input becomes invalid after 0.1 s</source>
        <translation>Débrancher l'entrée {0} : une entrée RC devient non valide 0,1 s plus tard</translation></message>
    <message><source>switched off</source>
        <translation>coupée</translation></message>
    <message><source>Fault</source>
        <translation>Défaut</translation></message>
    <message><source>Findings about the settings</source>
        <translation>Constats sur les réglages</translation></message>
    <message numerus="yes"><source>and %n more</source>
        <translation><numerusform>et encore %n</numerusform><numerusform>et encore %n</numerusform></translation></message>
    <message><source>Accept</source>
        <translation>Accepter</translation></message>
    <message><source>Show line {0}</source>
        <translation>Afficher la ligne {0}</translation></message>
    <message><source>These boards are armed, driven and stopped together as one robot. If one board no longer follows, the others stop.</source>
        <translation>Une zone, une activation et un arrêt conduisent ces cartes comme un seul robot. Une carte qui ne suit plus arrête les autres.</translation></message>
    <message><source>&amp;Drive together</source>
        <translation>&amp;Conduire ensemble</translation></message>
    <message><source>no problem</source>
        <translation>aucun problème</translation></message>
    <message><source>reversed</source>
        <translation>inversé</translation></message>
    <message><source>not driven</source>
        <translation>non conduit</translation></message>
    <message><source>Board {0}, motor {1}</source>
        <translation>Carte {0}, moteur {1}</translation></message>
    <message><source>Search times, boards, adapters (Ctrl+F)</source>
        <translation>Rechercher heures, cartes, adaptateurs (Ctrl+F)</translation></message>
    <message><source>Name the snapshot (or double-click it). A named snapshot is never deleted automatically</source>
        <translation>Celui qui a un nom est conservé, quel que soit le nombre des suivants ; aussi avec un double clic</translation></message>
    <message><source>Save a copy as a settings file</source>
        <translation>Enregistrer une copie comme fichier de réglages</translation></message>
    <message><source>There are no snapshots yet.

Before this program or trexcmd applies settings or restores defaults, all settings of the board are saved here. You can compare a snapshot with the board and restore some or all of its settings.</source>
        <translation>Il n'y a pas encore d'instantanés.

Avant d'appliquer des réglages ou de restaurer les valeurs par défaut, dans cette fenêtre ou avec trexcmd, tout ce que la carte contient est enregistré ici. Vous pouvez comparer un instantané avec la carte et le restaurer en tout ou en partie.</translation></message>
    <message numerus="yes"><source>Permanently delete %n snapshot(s), the newest from {0}?</source>
        <translation><numerusform>Supprimer définitivement %n instantané ({0}) ?</numerusform><numerusform>Supprimer définitivement %n instantanés (le plus récent : {0}) ?</numerusform></translation></message>
    <message><source>Search snapshots</source>
        <translation>Rechercher dans les instantanés</translation></message>
    <message><source>No snapshot matches the search.</source>
        <translation>Aucun instantané ne correspond à la recherche.</translation></message>
    <message><source>&amp;Name…</source>
        <translation>&amp;Nommer…</translation></message>
    <message><source>Save &amp;as…</source>
        <translation>Enregis&amp;trer sous…</translation></message>
    <message><source>Snapshots</source>
        <translation>Instantanés</translation></message>
    <message><source>Save a copy of the snapshot</source>
        <translation>Enregistrer une copie de l'instantané</translation></message>
    <message><source>&amp;History…</source>
        <translation>&amp;Historique…</translation></message>
    <message><source>A copy was saved to {0}.</source>
        <translation>Une copie a été enregistrée dans {0}.</translation></message>
    <message><source>Nothing was saved. {0}</source>
        <translation>Rien n'a été enregistré. {0}</translation></message>
    <message><source>Push every stick all the way forward or right first, then all the way in the other direction. Move every switch to all its positions. Hold each end position until it is ticked, then click Next.</source>
        <translation>Poussez d'abord chaque manche à fond vers l'avant ou vers la droite, puis dans l'autre sens. Mettez les interrupteurs dans toutes leurs positions. Maintenez chaque extrémité jusqu'à l'apparition de sa coche, puis cliquez sur « Suivant ».</translation></message>
    <message><source>This takes at least {0:.1f} s: at {1} baud only {2:.1f} measurements arrive per second.</source>
        <translation>Cela prend au moins {0:.1f} s : à {1} bauds, seules {2:.1f} mesures arrivent par seconde.</translation></message>
    <message><source>Push every stick to all its ends, then release it. Move every switch to all its positions. The motors stay off.</source>
        <translation>Poussez chaque manche vers toutes ses extrémités, puis relâchez-le. Mettez chaque interrupteur dans toutes ses positions. Les moteurs restent à l'arrêt.</translation></message>
    <message><source>The board sends no measurements: the line is busy or disturbed. Waiting …</source>
        <translation>La carte n'envoie aucune mesure : la liaison est occupée ou perturbée. Attente …</translation></message>
    <message><source>Release every stick and set every switch to off. Then click Next.</source>
        <translation>Relâchez tous les manches et mettez tous les interrupteurs en position inactive. Cliquez ensuite sur « Suivant ».</translation></message>
    <message><source>No channel is at rest. Click “Sample again”.</source>
        <translation>Aucune voie n'est au repos. Cliquez sur « Refaire la mesure ».</translation></message>
    <message><source>Nothing was learned. Go back, or start over.</source>
        <translation>Rien n'a été appris. Revenez en arrière ou recommencez.</translation></message>
    <message><source>No channel is selected.</source>
        <translation>Aucune voie n'est sélectionnée.</translation></message>
    <message><source>The board would reject the values of channel {0}: change them, or clear its check box.</source>
        <translation>La carte rejetterait les valeurs de la voie {0} : modifiez-les, ou décochez sa case.</translation></message>
    <message><source>Check the new values. Nothing has been written yet.</source>
        <translation>Vérifiez les nouvelles valeurs. Rien n'est encore écrit.</translation></message>
    <message><source>Stop the motors</source>
        <translation>Arrêter les moteurs</translation></message>
    <message><source>Hands off</source>
        <translation>Lâcher</translation></message>
    <message><source>All ends</source>
        <translation>Extrémités</translation></message>
    <message><source>Review</source>
        <translation>Vérifier</translation></message>
    <message><source>The new values are in the board. Stop the motors to test the values.</source>
        <translation>Les nouvelles valeurs sont dans la carte. Leur test doit d'abord arrêter les moteurs.</translation></message>
    <message><source>Sample &amp;again</source>
        <translation>Re&amp;faire la mesure</translation></message>
    <message><source>Start this step &amp;again</source>
        <translation>&amp;Recommencer l'étape</translation></message>
    <message><source>&amp;Start over</source>
        <translation>&amp;Recommencer</translation></message>
    <message><source>Test &amp;again</source>
        <translation>&amp;Tester à nouveau</translation></message>
    <message><source>Not every channel is at rest. Click “Sample again”, or Next to go on without channel {0}.</source>
        <translation>Toutes les voies ne sont pas au repos. Cliquez sur « Refaire la mesure », ou sur « Suivant » pour continuer sans la voie {0}.</translation></message>
    <message><source>Every channel works as it should.</source>
        <translation>Tout est en ordre.</translation></message>
    <message><source>Nothing to test: the board ignores this input (Ignored Channels).</source>
        <translation>Rien à tester : la carte ignore cette entrée (« Voies ignorées »).</translation></message>
    <message><source>The channels are good. But in {0} mode the motors would not start. {1}</source>
        <translation>Les voies sont bonnes. Mais en mode {0}, les moteurs ne démarreraient pas. {1}</translation></message>
    <message><source>Stop the motors and &amp;test</source>
        <translation>Arrêter les moteurs et &amp;tester</translation></message>
    <message><source>The motors are stopped: co&amp;ntinue</source>
        <translation>Les moteurs sont à l'arrêt : &amp;continuer</translation></message>
    <message><source>Try &amp;again</source>
        <translation>Réess&amp;ayer</translation></message>
    <message><source>Stopping the motors. The board must confirm the stop.</source>
        <translation>Arrêt des moteurs. La carte doit confirmer l'arrêt.</translation></message>
    <message><source>Hands off. Sampling … {0:.1f} s</source>
        <translation>Lâchez les manches. Mesure … {0:.1f} s</translation></message>
    <message><source>&amp;Test the sticks…</source>
        <translation>Teste&amp;r les manches…</translation></message>
    <message><source>&amp;Use these values…</source>
        <translation>&amp;Utiliser ces valeurs…</translation></message>
    <message><source>{0} end: not reached yet</source>
        <translation>Extrémité {0} : pas encore atteinte</translation></message>
    <message><source>{0} end: hold this position</source>
        <translation>Extrémité {0} : à maintenir</translation></message>
    <message><source>{0} end: reached</source>
        <translation>Extrémité {0} : atteinte</translation></message>
    <message><source>{0} end: not needed</source>
        <translation>Extrémité {0} : pas nécessaire</translation></message>
    <message><source>Calculated from the values in the board, separately for each channel. Two assumptions: outputs of up to 8 of 127 are neutral, and switches change halfway between neutral and the end (inferred).</source>
        <translation>Calculé à partir des valeurs de la carte, pour chaque voie séparément. Deux hypothèses : une sortie jusqu'à 8 sur 127 compte comme neutre, et les interrupteurs basculent à mi-chemin entre le neutre et l'extrémité (déduit).</translation></message>
    <message><source>Hold this position …</source>
        <translation>Maintenez cette position …</translation></message>
    <message><source>No end reached yet.</source>
        <translation>Aucune extrémité encore atteinte.</translation></message>
    <message><source>not sampled yet</source>
        <translation>pas encore mesuré</translation></message>
    <message><source>low</source>
        <translation>basse</translation></message>
    <message><source>high</source>
        <translation>haute</translation></message>
    <message><source>Left out: the rest position is unknown.</source>
        <translation>Omise : sa position de repos n'est pas connue.</translation></message>
    <message><source>Not held. Hold this position for {0:.1f} s.</source>
        <translation>Non maintenu. Maintenez-le là pendant {0:.1f} s.</translation></message>
    <message><source>Reached: {0}.</source>
        <translation>Atteint : {0}.</translation></message>
    <message><source>at rest: {0}, noise {1}</source>
        <translation>au repos : {0}, bruit {1}</translation></message>
    <message numerus="yes"><source>%n earlier pending edit(s) will also be written.</source>
        <translation><numerusform>%n modification antérieure en attente sera également écrite.</numerusform><numerusform>%n modifications antérieures en attente seront également écrites.</numerusform></translation></message>
    <message><source>Input now {0}; output {1}.</source>
        <translation>Entrée actuelle {0} ; sortie {1}.</translation></message>
    <message><source>&amp;Minimum</source>
        <translation>&amp;Minimum</translation></message>
    <message><source>&amp;Neutral</source>
        <translation>&amp;Neutre</translation></message>
    <message><source>Ma&amp;ximum</source>
        <translation>Ma&amp;ximum</translation></message>
    <message><source>&amp;Deadband</source>
        <translation>&amp;Zone morte</translation></message>
    <message><source>was reversed</source>
        <translation>était inversée</translation></message>
    <message><source>was not reversed</source>
        <translation>n'était pas inversée</translation></message>
    <message><source>&amp;Reversed</source>
        <translation>&amp;Inversée</translation></message>
    <message><source>proposed</source>
        <translation>proposé</translation></message>
    <message><source>as it was</source>
        <translation>avant</translation></message>
    <message><source>The new values of this channel will be used.</source>
        <translation>Ses nouvelles valeurs seront utilisées.</translation></message>
    <message><source>The channel was left out.</source>
        <translation>La voie a été omise.</translation></message>
    <message><source>This replaces a pending edit of the channel.</source>
        <translation>Ceci remplace une modification en attente de la voie.</translation></message>
    <message><source>Channels</source>
        <translation>Voies</translation></message>
    <message><source>No signal now: the output is 0.</source>
        <translation>Pas de signal actuellement : la sortie est à 0.</translation></message>
    <message><source>Nothing was learned.</source>
        <translation>Rien n'a été appris.</translation></message>
    <message><source>This channel keeps its old values.</source>
        <translation>Garde ses anciennes valeurs.</translation></message>
    <message><source>Check this channel.</source>
        <translation>Vérifiez cette voie.</translation></message>
    <message><source>Use &amp;channel {0}: {1}</source>
        <translation>Utiliser la &amp;voie {0} : {1}</translation></message>
    <message><source>Use {0} &amp;as neutral</source>
        <translation>Utiliser {0} &amp;comme neutre</translation></message>
    <message><source>{0}
was {1}</source>
        <translation>{0}
avant {1}</translation></message>
    <message><source>{0} of channel {1}</source>
        <translation>{0} de la voie {1}</translation></message>
    <message><source>These settings must match those of the board. A new board uses 19200 baud, no error detection and one stop bit. Changing them here does not change the board.</source>
        <translation>Ce doivent être les réglages que la carte a actuellement. Une carte neuve communique à 19200 bauds, sans détection d'erreurs, avec un bit d'arrêt. Les modifier ici ne change rien dans la carte.</translation></message>
    <message><source>&amp;Address one board by its device number (Pololu protocol)</source>
        <translation>Adresser une &amp;carte parmi plusieurs par son numéro (protocole Pololu)</translation></message>
    <message><source>Device numbers of other devices on this line, such as 0,1 (older Pololu motor and servo controllers). If you enter numbers, every packet has an address, no packet is sent to these numbers, and no other baud rate is tried.</source>
        <translation>Numéros d'autres appareils sur cette liaison, par exemple 0,1 (anciens contrôleurs de moteurs et de servos Pololu). Dès qu'il y en a un, chaque paquet est adressé, à aucun de ces numéros, et aucun autre débit n'est essayé.</translation></message>
    <message><source>&amp;Line:</source>
        <translation>&amp;Liaison :</translation></message>
    <message><source>CRC-7 &amp;polynomial:</source>
        <translation>&amp;Polynôme CRC-7 :</translation></message>
    <message><source>&amp;Device number:</source>
        <translation>&amp;Numéro d'appareil :</translation></message>
    <message><source>Nu&amp;mbers of other devices:</source>
        <translation>Nu&amp;méros des autres appareils :</translation></message>
    <message><source>&amp;Restore defaults</source>
        <translation>Restaurer les valeurs par &amp;défaut</translation></message>
    <message><source>&amp;Line settings…</source>
        <translation>Réglages de &amp;liaison…</translation></message>
    <message><source>Arming without a timeout is remembered for this board. If the cable falls out, cut the power by hand.</source>
        <translation>L'activation sans délai est mémorisée pour cette carte. Coupez alors l'alimentation à la main si le câble se débranche.</translation></message>
    <message><source>Arm with&amp;out a timeout</source>
        <translation>Activer &amp;sans délai</translation></message>
    <message><source>Writes Serial Timeout and UART-Error Shutdown now: the board should stop its motors {0} s after the last byte. Other changes stay pending.</source>
        <translation>Écrit maintenant « Délai série » et « Arrêt sur erreur UART » : la carte devrait arrêter ses moteurs {0} s après le dernier octet. Les autres modifications restent en attente.</translation></message>
    <message><source>Stops the motors and sends them no command until they are armed again</source>
        <translation>Arrête les moteurs et n'envoie rien jusqu'à leur réactivation</translation></message>
    <message numerus="yes"><source>Review %n ch&amp;ange(s)…</source>
        <translation><numerusform>Vérifier et appli&amp;quer (%n)…</numerusform><numerusform>Vérifier et appli&amp;quer (%n)…</numerusform></translation></message>
    <message><source>No ch&amp;anges</source>
        <translation>Rien à appli&amp;quer</translation></message>
    <message><source>Write the changed parameters into the board (Ctrl+Enter)</source>
        <translation>Écrire les paramètres modifiés dans la carte (Ctrl+Entrée)</translation></message>
    <message><source>Arm the motors</source>
        <translation>Activer les moteurs</translation></message>
    <message><source>Writing …</source>
        <translation>Écriture en cours …</translation></message>
    <message><source>Reconnect and stop</source>
        <translation>Reconnecter et arrêter</translation></message>
    <message><source>Stop both motors and the auxiliary now (Esc, anywhere)</source>
        <translation>Arrêter tout de suite les deux moteurs et l'auxiliaire (Échap, partout)</translation></message>
    <message><source>Armed</source>
        <translation>Moteurs activés</translation></message>
    <message><source>Disa&amp;rm</source>
        <translation>Désa&amp;ctiver</translation></message>
    <message><source>A&amp;rm motors</source>
        <translation>&amp;Activer les moteurs</translation></message>
    <message><source>Allows both motors and the auxiliary to be driven. Nothing moves yet</source>
        <translation>Permet de piloter les deux moteurs et l'auxiliaire ; rien ne bouge encore</translation></message>
    <message><source>Channels control the motors: Stop does not affect them.</source>
        <translation>Les voies commandent les moteurs : « Arrêter les moteurs » n'agit pas sur eux.</translation></message>
    <message><source>&amp;Write {0:g} s and arm</source>
        <translation>É&amp;crire {0:g} s et activer</translation></message>
    <message><source>The board did not store the serial timeout.</source>
        <translation>La carte n'a pas enregistré le délai série.</translation></message>
    <message><source>&amp;Stop motors</source>
        <translation>Arrêter le&amp;s moteurs</translation></message>
    <message><source>Write &amp;{0} s</source>
        <translation>Écrire &amp;{0} s</translation></message>
    <message><source>Why this value? Saved on this computer and in files.</source>
        <translation>Pourquoi cette valeur ? Conservé sur cet ordinateur et dans les fichiers.</translation></message>
    <message><source>Input source</source>
        <translation>Source des entrées</translation></message>
    <message><source>edited</source>
        <translation>modifiée</translation></message>
    <message><source>the calibration of {0}</source>
        <translation>l'étalonnage de la {0}</translation></message>
    <message><source>Re&amp;versed</source>
        <translation>Inver&amp;sée</translation></message>
    <message><source>The output changes its sign: forward and reverse are swapped</source>
        <translation>La sortie change de signe : avant et arrière sont inversés</translation></message>
    <message><source>Parab&amp;olic</source>
        <translation>Para&amp;bolique</translation></message>
    <message><source>Gentle near neutral, steep near the ends</source>
        <translation>Doux près du neutre, raide près des extrémités</translation></message>
    <message><source>I&amp;gnored</source>
        <translation>I&amp;gnorée</translation></message>
    <message><source>Holds the channel at neutral regardless of its input. For channels without a cable</source>
        <translation>Maintenue au neutre quelle que soit l'entrée ; pour les voies sans câble</translation></message>
    <message><source>Re&amp;quired in RC mode</source>
        <translation>&amp;Requise en mode RC</translation></message>
    <message><source>The motors stop when the pulses of this channel are missing for half a second</source>
        <translation>Les moteurs s'arrêtent quand ses impulsions manquent pendant une demi-seconde</translation></message>
    <message><source>Read the other input source</source>
        <translation>Lire l'autre source des entrées</translation></message>
    <message><source>Ma&amp;ke active…</source>
        <translation>Rendre act&amp;if…</translation></message>
    <message><source>The values of this input source have not been read yet.</source>
        <translation>Ses valeurs n'ont pas encore été lues.</translation></message>
    <message><source>Ne&amp;utral</source>
        <translation>Ne&amp;utre</translation></message>
    <message><source>Dead&amp;band ±</source>
        <translation>&amp;Zone morte ±</translation></message>
    <message><source>Stored: the board reads {0} after the next power cycle.</source>
        <translation>Enregistré : après la prochaine coupure et remise de l'alimentation, la carte lira : {0}.</translation></message>
    <message><source>The values below were {0}.</source>
        <translation>État des valeurs ci-dessous : {0}.</translation></message>
    <message><source>Read {0} after the next power cycle</source>
        <translation>Lire {0} après la prochaine coupure et remise de l'alimentation</translation></message>
    <message><source>Edited: apply the change, then power-cycle the board to read {0}.</source>
        <translation>Modifié : appliquez, puis coupez et remettez l'alimentation de la carte pour qu'elle lise : {0}.</translation></message>
    <message><source>Neutral</source>
        <translation>Neutre</translation></message>
    <message><source>Output</source>
        <translation>Sortie</translation></message>
    <message><source>Its handles can be dragged; the fields below set the same values.</source>
        <translation>Vous pouvez faire glisser ses poignées ; les champs ci-dessous règlent les mêmes valeurs.</translation></message>
    <message><source>Curve of the channel</source>
        <translation>Courbe de la voie</translation></message>
    <message><source>flip on</source>
        <translation>retournement actif</translation></message>
    <message><source>override on</source>
        <translation>priorité active</translation></message>
    <message><source>Inputs are read as {0}. They control the motors.</source>
        <translation>Les entrées sont lues comme {0}. Elles commandent les moteurs.</translation></message>
    <message><source>&amp;All other channels</source>
        <translation>&amp;Toutes les autres voies</translation></message>
    <message><source>&amp;Reset to factory defaults</source>
        <translation>&amp;Réinitialiser aux réglages d'usine</translation></message>
    <message><source>&amp;Discard the edits of this channel</source>
        <translation>Re&amp;jeter les modifications de cette voie</translation></message>
    <message><source>Learn a&amp;ll…</source>
        <translation>Tout appr&amp;endre…</translation></message>
    <message><source>Test stic&amp;ks…</source>
        <translation>C&amp;ontrôler les manches…</translation></message>
    <message><source>Live value</source>
        <translation>Valeur en direct</translation></message>
    <message><source>Learn &amp;this channel…</source>
        <translation>Apprendre cette &amp;voie…</translation></message>
    <message><source>Cop&amp;y and reset</source>
        <translation>&amp;Copier, réinitialiser</translation></message>
    <message><source>No board responds. Your edits are saved for the next board of the same model.</source>
        <translation>Aucune carte ne répond. Les modifications sont conservées jusqu'à ce qu'une carte du même type soit connectée.</translation></message>
    <message><source>Inputs are read as {0}. In serial mode they are only shown.</source>
        <translation>Les entrées sont lues comme {0}. En mode série, elles sont seulement affichées.</translation></message>
    <message><source>&amp;Copy to</source>
        <translation>Copier &amp;vers</translation></message>
    <message><source>Assumed values: Pololu publishes no factory defaults</source>
        <translation>Valeurs supposées : Pololu ne publie pas de réglages d'usine</translation></message>
    <message><source>Connect to a board to see and change its calibrations.</source>
        <translation>Connectez une carte pour voir et modifier ses étalonnages.</translation></message>
    <message><source>Inputs are read as {0}. Serial commands override them now.</source>
        <translation>Les entrées sont lues comme {0}. Les commandes série ont maintenant priorité.</translation></message>
    <message><source>Discard edits of channel {0}</source>
        <translation>Abandonner les modifications de la voie {0}</translation></message>
    <message><source>Copy calibration of channel {0}</source>
        <translation>Copie de l'étalonnage de la voie {0}</translation></message>
    <message><source>learned</source>
        <translation>apprise</translation></message>
    <message><source>factory calibration</source>
        <translation>étalonnage d'usine</translation></message>
    <message><source>problem</source>
        <translation>problème</translation></message>
    <message><source>{0:.0f} to {1:.0f} counts</source>
        <translation>{0:.0f} à {1:.0f} counts</translation></message>
    <message><source>Connect to a board to see its motor currents.</source>
        <translation>Connectez une carte pour voir les courants de ses moteurs.</translation></message>
    <message><source>Motor currents</source>
        <translation>Courants des moteurs</translation></message>
    <message><source>No board is connected. Select a port at the top of the main window and press Connect. If you have no hardware, select the demo board.</source>
        <translation>Aucune carte n'est connectée. Choisissez un port en haut de la fenêtre principale et cliquez sur « Connecter » ; sans matériel, choisissez la carte de démo.</translation></message>
    <message><source>Joint mode: the board does not sense currents.</source>
        <translation>Mode jumelé : la carte ne mesure pas les courants.</translation></message>
    <message><source>C&amp;urrents</source>
        <translation>&amp;Courants</translation></message>
    <message><source>One count of this board is {0:.0f} mA.</source>
        <translation>Un count de cette carte vaut {0:.0f} mA.</translation></message>
    <message><source>Reset all counts and error times</source>
        <translation>Remettre tous les compteurs à zéro et oublier quand les erreurs ont été vues</translation></message>
    <message><source>A restart is detected if the board comes back in another mode, because its power was off in the meantime. A restart in the same mode is not detected. Returns after silence: {0}.</source>
        <translation>La carte est revenue dans un autre mode, son alimentation a donc été coupée entre-temps ; elle ne signale pas un redémarrage dans le même mode. Retours après silence : {0}.</translation></message>
    <message><source>Reset all co&amp;unts</source>
        <translation>Remettre les compteurs à &amp;zéro</translation></message>
    <message><source>Reads per second</source>
        <translation>Lectures par seconde</translation></message>
    <message><source>Connected for</source>
        <translation>Connecté depuis</translation></message>
    <message><source>The line is noisy and has no CRC, so a corrupted reply can look like this error.</source>
        <translation>La liaison est bruitée et n'a pas de CRC : une réponse altérée y ressemble.</translation></message>
    <message><source>Latched before connecting, perhaps by a search for the board; not counted.</source>
        <translation>Mémorisée avant la connexion, peut-être par la recherche de la carte ; non comptée.</translation></message>
    <message><source>{0}, active now, stops the motors</source>
        <translation>{0}, active, arrête les moteurs</translation></message>
    <message><source>Answered, last {0:.0f} s</source>
        <translation>Réponses, dernières {0:.0f} s</translation></message>
    <message><source>{0}, no longer active</source>
        <translation>{0}, terminée</translation></message>
    <message><source>⚠ means 80 % of the limit or more.</source>
        <translation>⚠ signifie 80 % de la limite ou plus.</translation></message>
    <message><source>Speed 0: the motor is not driven and coasts</source>
        <translation>Vitesse 0 : le moteur n'est pas entraîné, il est en roue libre</translation></message>
    <message><source>Brake</source>
        <translation>Freiner</translation></message>
    <message><source>{0}, speed</source>
        <translation>{0}, vitesse</translation></message>
    <message><source>{0}, speed as a number</source>
        <translation>{0}, vitesse en chiffres</translation></message>
    <message><source>{0}, speed zero</source>
        <translation>{0}, vitesse zéro</translation></message>
    <message><source>{0}, brake</source>
        <translation>{0}, freiner</translation></message>
    <message><source>{0}, current</source>
        <translation>{0}, courant</translation></message>
    <message><source>Up to {0}, the speed ceiling</source>
        <translation>Jusqu'à {0}, la vitesse maximale</translation></message>
    <message><source>Hold an arrow key to drive while the pad has the focus.</source>
        <translation>Maintenez une touche fléchée pour piloter tant que le pavé a le focus.</translation></message>
    <message><source>Hold Up or Down to drive. The motors cannot be driven separately.</source>
        <translation>Maintenez Haut ou Bas pour piloter ; les moteurs ne peuvent pas tourner séparément.</translation></message>
    <message><source>At rest.</source>
        <translation>Au repos.</translation></message>
    <message><source>Drive pad</source>
        <translation>Pavé de conduite</translation></message>
    <message><source>back</source>
        <translation>arrière</translation></message>
    <message><source>{0} {1:.0%}, {2} {3:.0%}.</source>
        <translation>{0} {1:.0%}, {2} {3:.0%}.</translation></message>
    <message><source>ceiling {0:.0f} %</source>
        <translation>au plus {0:.0f} %</translation></message>
    <message><source>Full deflection is {0:.0f} % of full speed.</source>
        <translation>La pleine course correspond à {0:.0f} % de la pleine vitesse.</translation></message>
    <message><source>The gamepad cannot drive while this window is open, but its stop button works.</source>
        <translation>La manette ne peut pas piloter tant que cette fenêtre est ouverte, mais son bouton d'arrêt fonctionne.</translation></message>
    <message><source>Invert</source>
        <translation>Inverser</translation></message>
    <message><source>Set up the gamepad</source>
        <translation>Configurer la manette</translation></message>
    <message><source>Assignment</source>
        <translation>Affectation</translation></message>
    <message><source>One axis drives, the other turns</source>
        <translation>Un axe fait avancer, l'autre tourner</translation></message>
    <message><source>One axis for each motor</source>
        <translation>Un axe par moteur</translation></message>
    <message><source>&amp;Hold to drive</source>
        <translation>&amp;Maintenir pour piloter</translation></message>
    <message><source>&amp;Stop everything</source>
        <translation>&amp;Tout arrêter</translation></message>
    <message><source>St&amp;icks:</source>
        <translation>Man&amp;ches :</translation></message>
    <message><source>&amp;Dead zone:</source>
        <translation>&amp;Zone morte :</translation></message>
    <message><source>&amp;Expo:</source>
        <translation>&amp;Expo :</translation></message>
    <message><source>Without a hold button, bumping a stick drives the motors. The gamepad cannot drive while this window is open.</source>
        <translation>Sans bouton à maintenir, un manche heurté fait tourner les moteurs. La manette ne peut pas piloter tant que cette fenêtre est ouverte.</translation></message>
    <message><source>none: moving a stick drives</source>
        <translation>aucun : un manche déplacé fait tourner les moteurs</translation></message>
    <message><source>Live state</source>
        <translation>État en direct</translation></message>
    <message><source>Travel around the centre that has no effect</source>
        <translation>Course autour du centre qui reste sans effet</translation></message>
    <message><source>0 %: linear. 100 %: cubic, finest around the centre</source>
        <translation>0 % : linéaire. 100 % : cubique, le plus fin autour du centre</translation></message>
    <message><source>&amp;Left motor</source>
        <translation>Moteur &amp;gauche</translation></message>
    <message><source>Right &amp;motor</source>
        <translation>Moteur &amp;droit</translation></message>
    <message><source>pressed</source>
        <translation>appuyé</translation></message>
    <message><source>{0}: inverted</source>
        <translation>{0} : inversé</translation></message>
    <message><source>&amp;Gamepad</source>
        <translation>&amp;Manette</translation></message>
    <message><source>Drive with a gamepad</source>
        <translation>Piloter avec une manette</translation></message>
    <message><source>Set &amp;up…</source>
        <translation>&amp;Configurer…</translation></message>
    <message><source>Stop when behi&amp;nd another window</source>
        <translation>Arrêter derrière d'autr&amp;es fenêtres</translation></message>
    <message><source>The gamepad is being set up and cannot drive.</source>
        <translation>La manette est en cours de configuration et ne peut pas piloter.</translation></message>
    <message><source>The gamepad drives only while the Motors page is open.</source>
        <translation>La manette ne pilote que tant que la page Moteurs est ouverte.</translation></message>
    <message><source>Another window is in front, so the gamepad cannot drive.</source>
        <translation>Une autre fenêtre est au premier plan : la manette ne peut pas piloter.</translation></message>
    <message><source>Stop the motors that the gamepad drives when the window loses the focus</source>
        <translation>Arrêter ce que pilote la manette quand la fenêtre perd le focus</translation></message>
    <message><source>Maximum speed that this program sends to this board. Full deflection of the pad, the keys or the gamepad gives this speed. Raising the ceiling does not speed up a running motor.</source>
        <translation>Vitesse la plus élevée que ce programme envoie à cette carte ; la pleine course du pavé, des touches et de la manette donne cette vitesse. L'augmenter n'accélère pas un moteur en marche.</translation></message>
    <message><source>&amp;Speed ceiling</source>
        <translation>&amp;Vitesse maximale</translation></message>
    <message><source>Raise the ceiling once the motors turn the right way.</source>
        <translation>À augmenter quand le sens de rotation est bon.</translation></message>
    <message><source>Held keys drive wherever the focus is on this page, except in number fields, tables and lists. Arrow keys then no longer move the sliders. While the pad has the focus, keys always drive.</source>
        <translation>Les touches maintenues pilotent où que soit le focus sur cette page, sauf dans les champs numériques, les tableaux et les listes ; les curseurs ne reçoivent alors pas les touches fléchées. Dans le pavé, elles pilotent toujours.</translation></message>
    <message><source>Both motors &amp;linked</source>
        <translation>Les deu&amp;x moteurs liés</translation></message>
    <message><source>Either slider sets both motors, so the robot does not turn</source>
        <translation>L'un ou l'autre curseur règle les deux moteurs ; le robot ne tourne pas</translation></message>
    <message><source>The motors run at different speeds: stop both, or set both to the same speed</source>
        <translation>Les moteurs tournent différemment : arrêtez-les tous les deux ou donnez-leur la même vitesse</translation></message>
    <message><source>Accelerate along the board's ra&amp;mp</source>
        <translation>Accélérer &amp;selon la rampe de la carte</translation></message>
    <message><source>The board ramps speeds at the Acceleration setting and pauses for the brake duration before reversing</source>
        <translation>La carte fait varier les vitesses selon le réglage « Accélération » et marque une pause de la durée de freinage avant d'inverser le sens</translation></message>
    <message><source>Bypasses the ramp and the brake duration, and briefly the current limit</source>
        <translation>Contourne la rampe et la durée de freinage, et aussi, un instant, la limite de courant</translation></message>
    <message><source>Strength of braking with the Brake button, and after you release the pad, a key or a held slider. Stop always brakes fully</source>
        <translation>Force du freinage par « Freiner » et au relâchement du pavé, des touches et des curseurs maintenus ; l'arrêt freine toujours à fond</translation></message>
    <message><source>&amp;Brake strength</source>
        <translation>Intensité du freina&amp;ge</translation></message>
    <message><source>Loc&amp;k after Stop</source>
        <translation>Verr&amp;ouillage après un arrêt</translation></message>
    <message><source>Stop when you lea&amp;ve this page</source>
        <translation>Arrêter en quittant &amp;cette page</translation></message>
    <message><source>Stop both motors and the auxiliary when another page is shown or the window is minimized</source>
        <translation>Arrêter les deux moteurs et l'auxiliaire quand une autre page est affichée ou que la fenêtre est réduite</translation></message>
    <message><source>Sliders return to &amp;zero</source>
        <translation>Curseurs remis à &amp;zéro</translation></message>
    <message><source>A slider drives its motor only while you hold the slider. Releasing the slider brakes the motor</source>
        <translation>Un curseur ne fait tourner son moteur que tant que vous le tenez ; le relâcher freine le moteur</translation></message>
    <message><source>Drive with</source>
        <translation>Piloter avec</translation></message>
    <message><source>Arrow ke&amp;ys or WASD</source>
        <translation>Flèches ou &amp;WASD</translation></message>
    <message><source>E&amp;xtra options</source>
        <translation>A&amp;utres options</translation></message>
    <message><source>coast (0 %)</source>
        <translation>roue libre (0 %)</translation></message>
    <message><source>none (0 s)</source>
        <translation>aucun (0 s)</translation></message>
    <message><source>How long arming stays locked after Stop or Esc, so that a slider or key that is still held cannot restart a motor (0 to {0:g} s)</source>
        <translation>Durée pendant laquelle l'activation reste verrouillée après un arrêt ou Échap, pour qu'un curseur ou une touche encore maintenus ne puissent pas relancer un moteur (0 à {0:g} s)</translation></message>
    <message><source>stop after {0}</source>
        <translation>arrêt après {0}</translation></message>
    <message><source>may keep turning</source>
        <translation>continuent peut-être</translation></message>
    <message><source>Ramp</source>
        <translation>Rampe</translation></message>
    <message><source>Brake before reversal</source>
        <translation>Freinage avant inversion</translation></message>
    <message><source>Current limit</source>
        <translation>Limite de courant</translation></message>
    <message><source>&amp;Open plot</source>
        <translation>Voir la cour&amp;be</translation></message>
    <message><source>How the board applies commands</source>
        <translation>Comment la carte applique les commandes</translation></message>
    <message><source>Armed: these controls move the motors.</source>
        <translation>Moteurs activés : ces commandes les font tourner.</translation></message>
    <message><source>Left</source>
        <translation>Gauche</translation></message>
    <message><source>Right</source>
        <translation>Droite</translation></message>
    <message><source>Motor (joint)</source>
        <translation>Moteur (jumelé)</translation></message>
    <message><source>Brake with {0}</source>
        <translation>Freiner à {0}</translation></message>
    <message><source>one way</source>
        <translation>un seul sens</translation></message>
    <message><source>The Motors page was left while a control was held.</source>
        <translation>La page Moteurs a été quittée alors qu'une commande était maintenue.</translation></message>
    <message><source>The Motors page was left.</source>
        <translation>La page Moteurs a été quittée.</translation></message>
    <message><source>keep turning</source>
        <translation>continuent de tourner</translation></message>
    <message><source>Apply each change of one motor to both motors, in one step</source>
        <translation>Reporter en une seule étape chaque modification d'un moteur sur l'autre</translation></message>
    <message><source>No document confirms this limit. The board may accept other values.</source>
        <translation>Aucun document ne confirme cette limite. La carte décide des autres valeurs.</translation></message>
    <message><source>Show the steps for switching the board off and on</source>
        <translation>Afficher les étapes pour couper et remettre l'alimentation de la carte</translation></message>
    <message><source>Detail&amp;s</source>
        <translation>Détail&amp;s</translation></message>
    <message><source>&amp;Both motors as one</source>
        <translation>Les deux moteurs &amp;ensemble</translation></message>
    <message><source>Wire value</source>
        <translation>Valeur transmise</translation></message>
    <message><source>&amp;Try this value</source>
        <translation>&amp;Essayer cette valeur</translation></message>
    <message><source>Selected parameter</source>
        <translation>Paramètre sélectionné</translation></message>
    <message><source>{0}, or speed steps such as {1}. The board stores the nearest time.</source>
        <translation>{0}. La carte enregistre le temps le plus proche. Ou en pas de vitesse, par exemple {1}.</translation></message>
    <message><source>The PWM frequency must be {0}, not {1}.</source>
        <translation>La fréquence PWM est {0}, et non {1}.</translation></message>
    <message><source>Baud rate</source>
        <translation>Débit (bauds)</translation></message>
    <message><source>Error detection</source>
        <translation>Détection d'erreurs</translation></message>
    <message><source>Stop bits</source>
        <translation>Bits d'arrêt</translation></message>
    <message><source>CRC-7</source>
        <translation>CRC-7</translation></message>
    <message><source>unknown ({0})</source>
        <translation>inconnu ({0})</translation></message>
    <message><source>{0}: channel {1}</source>
        <translation>{0} : voie {1}</translation></message>
    <message><source>Search parameters</source>
        <translation>Rechercher des paramètres</translation></message>
    <message><source>Edit, then review. Nothing is written before the review.</source>
        <translation>Modifiez, puis vérifiez. Rien n'est écrit avant.</translation></message>
    <message><source>&amp;Show all parameters</source>
        <translation>&amp;Afficher tous les paramètres</translation></message>
    <message><source>All</source>
        <translation>Tous</translation></message>
    <message><source>Changed {0}</source>
        <translation>Modifiés {0}</translation></message>
    <message><source>Not default {0}</source>
        <translation>Hors défaut {0}</translation></message>
    <message><source>Findings {0}</source>
        <translation>Constats {0}</translation></message>
    <message><source>Parameters</source>
        <translation>Paramètres</translation></message>
    <message><source>Connect to a board to see its parameters.</source>
        <translation>Connectez une carte pour voir ses paramètres.</translation></message>
    <message><source>Factory defaults take effect after the next power cycle.</source>
        <translation>Les réglages d'usine prennent effet après avoir coupé et remis l'alimentation.</translation></message>
    <message><source>Stored, but not active until the board is switched off and on: {0}.</source>
        <translation>Enregistré, mais inactif tant que l'alimentation de la carte n'a pas été coupée puis remise : {0}.</translation></message>
    <message><source>No parameter matches.</source>
        <translation>Aucun paramètre ne correspond.</translation></message>
    <message><source>{0}: the motors stop.</source>
        <translation>{0} : les moteurs s'arrêtent.</translation></message>
    <message><source>{0}: the motors may not stop.</source>
        <translation>{0} : les moteurs ne s'arrêtent peut-être pas.</translation></message>
    <message><source>Speed after an accelerate command: {0}. The motor slows down at once.</source>
        <translation>Vitesse après une commande d'accélération : {0}. Le ralentissement est immédiat.</translation></message>
    <message><source>Reversal by an accelerate command: {0}, then the ramp.</source>
        <translation>Inversion par une commande d'accélération : {0}, puis la rampe.</translation></message>
    <message><source>Current of a starting motor, limit: {0}</source>
        <translation>Courant d'un moteur qui démarre, limite : {0}</translation></message>
    <message><source>{0}: the motors keep running.</source>
        <translation>{0} : les moteurs continuent de tourner.</translation></message>
    <message><source>Speed against the stick position, brake in the deadband: {0}</source>
        <translation>Vitesse selon le manche, freinage en zone morte : {0}</translation></message>
    <message><source>Und&amp;o edit</source>
        <translation>Annule&amp;r</translation></message>
    <message><source>Edit</source>
        <translation>Modifier</translation></message>
    <message><source>Try another &amp;wire value…</source>
        <translation>Essayer une autre valeur &amp;transmise…</translation></message>
    <message><source>Defa&amp;ult</source>
        <translation>Valeur par défa&amp;ut</translation></message>
    <message><source>Leave out of the fi&amp;le</source>
        <translation>&amp;Ne pas inclure dans le fichier</translation></message>
    <message><source>Copy as “{0}”</source>
        <translation>Copier comme « {0} »</translation></message>
    <message><source>{0}; the channels control the motors.</source>
        <translation>{0} ; les voies commandent les moteurs.</translation></message>
    <message><source>Serial mode with {0} inputs</source>
        <translation>Mode série, entrées {0}</translation></message>
    <message><source>{0} mode</source>
        <translation>Mode {0}</translation></message>
    <message><source>{0}.</source>
        <translation>{0}.</translation></message>
    <message><source>{0}; serial commands reach the motors.</source>
        <translation>{0} ; les commandes série atteignent les moteurs.</translation></message>
    <message><source>{0}, setpoint {1}</source>
        <translation>{0}, consigne : {1}</translation></message>
    <message><source>{0}, remapped {1}</source>
        <translation>{0}, converti : {1}</translation></message>
    <message><source>brake {0}</source>
        <translation>freinage {0}</translation></message>
    <message><source>Switch the board off for at least one second. Waiting for the board to stop responding …</source>
        <translation>Coupez l'alimentation de la carte pendant au moins une seconde. Attente que la carte cesse de répondre …</translation></message>
    <message><source>The board still responds. A short interruption is not detected: leave the power off for a full second.</source>
        <translation>La carte répond encore. Une coupure brève n'est pas détectée : laissez l'alimentation coupée une seconde entière.</translation></message>
    <message><source>Switch the board on again. Waiting for the board to respond …</source>
        <translation>Remettez-la sous tension. Attente qu'elle réponde de nouveau …</translation></message>
    <message><source>The board is still not responding. Check its power and the cable. If both are fine, disconnect and press “Find…”, which tries every setting.</source>
        <translation>La carte ne répond toujours pas. Vérifiez son alimentation et le câble. Si les deux sont en ordre, déconnectez et cliquez sur « Rechercher… », qui essaie tous les réglages.</translation></message>
    <message><source>The connection was closed. Switch the board off and on, then connect again. If that fails, press “Find…”, which tries every setting.</source>
        <translation>La liaison a été fermée. Coupez et remettez l'alimentation de la carte, puis reconnectez ; « Rechercher… » essaie tous les réglages.</translation></message>
    <message><source>Connected again. The program cannot detect whether the board was switched off in the meantime. Confirm that it was, or switch the board off and on now.</source>
        <translation>De nouveau connecté. Le programme ne peut pas détecter si l'alimentation de la carte a été coupée entre-temps : confirmez-le, ou coupez et remettez son alimentation maintenant.</translation></message>
    <message><source>The board is back, and all stored settings are active.</source>
        <translation>La carte est de retour et tous les réglages enregistrés sont actifs.</translation></message>
    <message><source>I have &amp;switched the board off and on</source>
        <translation>J'ai &amp;coupé et remis l'alimentation</translation></message>
    <message><source>Switch off</source>
        <translation>Couper</translation></message>
    <message><source>Read again</source>
        <translation>Relire</translation></message>
    <message><source>Switch the board off and on</source>
        <translation>Couper et remettre l'alimentation de la carte</translation></message>
    <message><source>Power cycle completed.</source>
        <translation>Alimentation coupée et remise.</translation></message>
    <message><source>The board is back, but these settings are still not active: {0}.</source>
        <translation>La carte est de retour, mais ces réglages ne sont toujours pas actifs : {0}.</translation></message>
    <message><source>The program then reconnects at {0}.</source>
        <translation>Le programme se reconnecte ensuite à {0}.</translation></message>
    <message numerus="yes"><source>Edited earlier but not applied: %n setting(s) of this {0} ({1}). Restore them as pending edits?</source>
        <translation><numerusform>Modifié auparavant mais pas appliqué : %n réglage de ce {0} ({1}). Le restaurer comme modification en attente ?</numerusform><numerusform>Modifiés auparavant mais pas appliqués : %n réglages de ce {0} ({1}). Les restaurer comme modifications en attente ?</numerusform></translation></message>
    <message><source>Settings are still being written. Close anyway? Unwritten settings are offered when the board is connected again.</source>
        <translation>Des réglages sont encore en cours d'écriture. Fermer quand même ? Les réglages non écrits seront proposés quand la carte sera de nouveau connectée.</translation></message>
    <message><source>Close anyway</source>
        <translation>Fermer quand même</translation></message>
    <message><source>Review and apply…</source>
        <translation>Vérifier et appliquer…</translation></message>
    <message><source>There are unapplied changes.</source>
        <translation>Il y a des modifications non appliquées.</translation></message>
    <message numerus="yes"><source>%n setting(s) of this {0} differ from the last applied values ({1}). They were lost or changed by another program, or this is another board.</source>
        <translation><numerusform>%n réglage de ce {0} diffère de ce qui a été appliqué en dernier ({1}) : perdu, modifié par autre chose, ou c'est une autre carte.</numerusform><numerusform>%n réglages de ce {0} diffèrent de ce qui a été appliqué en dernier ({1}) : perdus, modifiés par autre chose, ou c'est une autre carte.</numerusform></translation></message>
    <message><source>Keep the values of the board</source>
        <translation>Garder les valeurs de la carte</translation></message>
    <message><source>You may drive now: arm the motors.</source>
        <translation>Vous pouvez piloter maintenant : activez les moteurs.</translation></message>
    <message><source>{0} wants to drive. Handing over stops the motors.</source>
        <translation>{0} demande à piloter. Céder arrête les moteurs.</translation></message>
    <message><source>Hand over</source>
        <translation>Céder</translation></message>
    <message><source>{0} is driving. Taking over stops the motors.</source>
        <translation>{0} pilote. La reprise arrête les moteurs.</translation></message>
    <message><source>Take over</source>
        <translation>Reprendre</translation></message>
    <message><source>Save as a settings file…</source>
        <translation>Enregistrer comme fichier de réglages…</translation></message>
    <message><source>Keep and close</source>
        <translation>Conserver et fermer</translation></message>
    <message><source>Discard and close</source>
        <translation>Abandonner et fermer</translation></message>
    <message><source>Show…</source>
        <translation>Afficher…</translation></message>
    <message><source>A new board: its device number is not in the record.</source>
        <translation>Une nouvelle carte : son numéro d'appareil ne figure dans aucune ligne du registre.</translation></message>
    <message><source>Known: its device number and its calibrations are in the record.</source>
        <translation>Connue : son numéro d'appareil et ses étalonnages figurent dans le registre.</translation></message>
    <message><source>Probably known: its device number is in the record, but with other calibrations.</source>
        <translation>Probablement connue : son numéro d'appareil figure dans le registre, avec d'autres étalonnages.</translation></message>
    <message><source>skipped</source>
        <translation>passée</translation></message>
    <message><source>First device number</source>
        <translation>Premier numéro d'appareil</translation></message>
    <message><source>The profile is a settings file. Each board gets the settings of the profile, a device number that no other board has, and a line in the record. The record is a CSV file. An existing file is extended.</source>
        <translation>Le profil est un fichier de réglages. Chaque carte reçoit ses réglages, un numéro d'appareil qu'aucune autre n'a, et une ligne dans le registre : un fichier CSV, complété s'il existe déjà.</translation></message>
    <message><source>Boards have no serial number. A board whose device number is in the record keeps this number.</source>
        <translation>Les cartes n'ont pas de numéro de série. Celle dont le numéro d'appareil figure dans le registre le garde.</translation></message>
    <message><source>Select…</source>
        <translation>Choisir…</translation></message>
    <message><source>CSV files (*.csv);;All files (*)</source>
        <translation>Fichiers CSV (*.csv);;Tous les fichiers (*)</translation></message>
    <message><source>Record of the boards</source>
        <translation>Registre des cartes</translation></message>
    <message><source>Finished boards</source>
        <translation>Cartes terminées</translation></message>
    <message><source>{0}, device number {1}: {2}</source>
        <translation>{0}, numéro d'appareil {1} : {2}</translation></message>
    <message><source>What every board gets</source>
        <translation>Ce que reçoit chaque carte</translation></message>
    <message><source>&amp;Profile:</source>
        <translation>P&amp;rofil :</translation></message>
    <message><source>&amp;Record:</source>
        <translation>Re&amp;gistre :</translation></message>
    <message><source>Then turn each &amp;motor while a button is held</source>
        <translation>Ensuite, faire tourner chaque &amp;moteur tant qu'un bouton est maintenu</translation></message>
    <message><source>Plug in a board, and switch it on.</source>
        <translation>Branchez une carte et mettez-la sous tension.</translation></message>
    <message><source>{0}: {1}. Unplug this board, and plug in the next board.</source>
        <translation>{0} : {1}. Débranchez-la et branchez la carte suivante.</translation></message>
    <message><source>Hold each button: does its motor turn?</source>
        <translation>Maintenez chaque bouton : son moteur tourne-t-il ?</translation></message>
    <message><source>Profile</source>
        <translation>Profil</translation></message>
    <message><source>Plug in</source>
        <translation>Brancher</translation></message>
    <message><source>Write</source>
        <translation>Écrire</translation></message>
    <message><source>Unplug</source>
        <translation>Débrancher</translation></message>
    <message><source>Set up boards in turn</source>
        <translation>Configurer des cartes l'une après l'autre</translation></message>
    <message><source>&amp;Names:</source>
        <translation>&amp;Noms :</translation></message>
    <message><source>&amp;First number:</source>
        <translation>Premier n&amp;uméro :</translation></message>
    <message><source>Profile for every board</source>
        <translation>Profil de chaque carte</translation></message>
    <message><source>This board cannot be set up. Unplug it.</source>
        <translation>Cette carte ne peut pas être configurée. Débranchez-la.</translation></message>
    <message><source>Connect to a board: use Connect or Find in the main window.</source>
        <translation>Connectez une carte : avec « Connecter » ou « Rechercher » dans la fenêtre principale.</translation></message>
    <message><source>&amp;Write and check</source>
        <translation>&amp;Écrire et vérifier</translation></message>
    <message><source>M&amp;otors</source>
        <translation>M&amp;oteurs</translation></message>
    <message><source>&amp;Start</source>
        <translation>&amp;Démarrer</translation></message>
    <message><source>Both &amp;turned</source>
        <translation>Les &amp;deux ont tourné</translation></message>
    <message><source>&amp;Try again</source>
        <translation>R&amp;éessayer</translation></message>
    <message><source>The wheels are &amp;off the ground</source>
        <translation>&amp;Les roues ne touchent pas le sol</translation></message>
    <message><source>Short, weak pulses while you hold the button with the mouse or the space bar</source>
        <translation>Impulsions courtes et faibles tant que vous le maintenez avec la souris ou la barre d'espace</translation></message>
    <message><source>Armed. The motor turns in short, weak pulses while you hold the button.</source>
        <translation>Activé. Le moteur tourne par impulsions courtes et faibles tant que vous maintenez.</translation></message>
    <message><source>Motor {0} is driven in pulses. Release the button to stop the motor.</source>
        <translation>Le moteur {0} tourne par impulsions. Relâchez le bouton pour l'arrêter.</translation></message>
    <message><source>Hold to turn motor {0}</source>
        <translation>Maintenir : le moteur {0} tourne</translation></message>
    <message><source>&amp;Keep 30 s around each fault and stop</source>
        <translation>&amp;Garder 30 s autour de chaque défaut ou arrêt</translation></message>
    <message><source>The seconds around “{0}” were saved as {1} (File, Open fault or stop).</source>
        <translation>Les secondes autour de « {0} » ont été conservées. Fichier, Ouvrir un défaut ou un arrêt : {1}</translation></message>
    <message><source>The seconds around “{0}” could not be saved. {1}</source>
        <translation>Les secondes autour de « {0} » n'ont pas pu être conservées. {1}</translation></message>
    <message><source>Start recording &amp;when the motors are armed</source>
        <translation>Démarrer l'enregistrement &amp;avec l'activation des moteurs</translation></message>
    <message><source>Nothing can be recorded: no board is connected.</source>
        <translation>Rien ne peut être enregistré : aucune carte n'est connectée.</translation></message>
    <message><source>File, Open recording</source>
        <translation>Fichier, Ouvrir un enregistrement</translation></message>
    <message><source>Open recor&amp;ding…</source>
        <translation>Ouvrir un enregistre&amp;ment…</translation></message>
    <message><source>Open fa&amp;ult or stop…</source>
        <translation>Ouvrir un &amp;défaut ou un arrêt…</translation></message>
    <message><source>Left wheel, forward</source>
        <translation>Roue gauche, vers l'avant</translation></message>
    <message><source>Right wheel, forward</source>
        <translation>Roue droite, vers l'avant</translation></message>
    <message><source>Left wheel, backward</source>
        <translation>Roue gauche, vers l'arrière</translation></message>
    <message><source>Right wheel, backward</source>
        <translation>Roue droite, vers l'arrière</translation></message>
    <message><source>Nothing</source>
        <translation>Rien</translation></message>
    <message><source>Robots that “trexcmd serve” offers on this computer and on the local network.</source>
        <translation>Servis avec trexcmd serve : par cet ordinateur, et par d'autres du réseau local.</translation></message>
    <message numerus="yes"><source>%n robot(s) stopped.</source>
        <translation><numerusform>%n robot arrêté.</numerusform><numerusform>%n robots arrêtés.</numerusform></translation></message>
    <message><source>Robot</source>
        <translation>Robot</translation></message>
    <message><source>Driver</source>
        <translation>Pilotage</translation></message>
    <message><source>Problems</source>
        <translation>Problèmes</translation></message>
    <message><source>Robots</source>
        <translation>Robots</translation></message>
    <message><source>Stop &amp;all robots</source>
        <translation>Arrêter &amp;tous les robots</translation></message>
    <message><source>&amp;Search again</source>
        <translation>Cherc&amp;her encore</translation></message>
    <message><source>&amp;Connect</source>
        <translation>Connec&amp;ter</translation></message>
    <message><source>Searching …</source>
        <translation>Recherche …</translation></message>
    <message><source>Stopping …</source>
        <translation>Arrêt …</translation></message>
    <message><source>Robots on the net&amp;work…</source>
        <translation>Robots v&amp;isibles sur le réseau…</translation></message>
    <message><source>No robots found.</source>
        <translation>Aucun robot trouvé.</translation></message>
    <message><source>no board</source>
        <translation>aucune carte</translation></message>
    <message><source>Stop not confirmed: {0}</source>
        <translation>Non confirmé : {0}</translation></message>
    <message><source>{0}, not responding</source>
        <translation>{0}, ne répond pas</translation></message>
    <message><source>Read the settings from the board and discard the edits made here?</source>
        <translation>Lire les réglages de la carte et abandonner les modifications faites ici ?</translation></message>
    <message><source>{0} is now one of the pending changes and takes effect after the board is switched off and on. This window then uses the new setting. Other programs on this line must also use the new setting.</source>
        <translation>{0} fait maintenant partie des modifications en attente. La modification prend effet une fois l'alimentation de la carte coupée puis remise ; cette fenêtre suit alors. Les autres programmes de cette liaison doivent l'utiliser aussi.</translation></message>
    <message><source>Discard and reload</source>
        <translation>Abandonner et recharger</translation></message>
    <message><source>&amp;Add to the file</source>
        <translation>&amp;Ajouter au fichier</translation></message>
    <message><source>Not in the file: the board keeps its own calibration.</source>
        <translation>Absent du fichier : la carte garde le sien.</translation></message>
    <message><source>Bold: differs from the factory default.</source>
        <translation>Gras : diffère du réglage d'usine.</translation></message>
    <message><source>Key</source>
        <translation>Clé</translation></message>
    <message><source>Value</source>
        <translation>Valeur</translation></message>
    <message><source>Channel</source>
        <translation>Voie</translation></message>
    <message><source>Printed {0} by TReX Studio.</source>
        <translation>Imprimé le {0} par TReX Studio.</translation></message>
    <message><source>Findings</source>
        <translation>Constats</translation></message>
    <message><source>Calibrations</source>
        <translation>Étalonnages</translation></message>
    <message><source>None set.</source>
        <translation>Aucun n'est indiqué.</translation></message>
    <message><source>Convert values with units to wire values, and replace numbers that are out of range with the nearest valid number. The file changes only when you save it</source>
        <translation>Écrire les valeurs avec unités comme elles sont transmises, et remplacer les nombres hors plage par la valeur permise la plus proche ; le fichier change quand vous l'enregistrez</translation></message>
    <message><source>&amp;Repair values</source>
        <translation>&amp;Réparer les valeurs</translation></message>
    <message><source>Text of the settings file</source>
        <translation>Texte du fichier de réglages</translation></message>
    <message><source>“Save” writes this text. Comments and the order of the lines do not change. To change values, use the other pages.</source>
        <translation>« Enregistrer » écrit ce texte. Les commentaires et l'ordre des lignes restent tels quels ; modifiez les valeurs sur les autres pages.</translation></message>
    <message><source>Chec&amp;k again</source>
        <translation>&amp;Vérifier de nouveau</translation></message>
    <message><source>Read the text again and list its errors</source>
        <translation>Relire le texte et lister ses erreurs</translation></message>
    <message><source>This file cannot be used. Correct the text here, then check it again. The other pages become available once the text has no errors.</source>
        <translation>Ce fichier ne peut pas être utilisé. Corrigez le texte ici, puis vérifiez-le de nouveau ; les autres pages s'ouvrent dès qu'il n'a plus d'erreurs.</translation></message>
    <message><source>Line numbers</source>
        <translation>Numéros de ligne</translation></message>
    <message><source>This is the text as it was opened, without your changes: {0}. Save offers to rewrite the file from the settings.</source>
        <translation>Ceci est le texte tel qu'il a été ouvert, sans vos modifications : {0}. « Enregistrer » propose de réécrire le fichier à partir des réglages.</translation></message>
    <message><source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation></message>
    <message><source>Text</source>
        <translation>Texte</translation></message>
    <message><source>&amp;File</source>
        <translation>&amp;Fichier</translation></message>
    <message><source>&amp;Edit</source>
        <translation>É&amp;dition</translation></message>
    <message><source>&amp;Compare</source>
        <translation>&amp;Comparer</translation></message>
    <message><source>&amp;Device</source>
        <translation>Apparei&amp;l</translation></message>
    <message><source>&amp;Save settings file…</source>
        <translation>&amp;Enregistrer un fichier de réglages…</translation></message>
    <message><source>Save as P&amp;DF…</source>
        <translation>Enregistrer en P&amp;DF…</translation></message>
    <message><source>Compare &amp;with:</source>
        <translation>Comparer &amp;avec :</translation></message>
    <message><source>Nothing could be repaired: correct the text in the lines named below.</source>
        <translation>Rien n'a pu être réparé : corrigez le texte aux lignes indiquées ci-dessous.</translation></message>
    <message><source>Tool bar</source>
        <translation>Barre d'outils</translation></message>
    <message><source>The file still has errors.</source>
        <translation>Il contient encore des erreurs.</translation></message>
    <message><source>Factory defaults</source>
        <translation>Réglages d'usine</translation></message>
    <message><source>The text no longer has errors; all pages are available.</source>
        <translation>Le texte n'a plus d'erreurs ; toutes les pages sont disponibles.</translation></message>
    <message><source>Correct the rest in the text.</source>
        <translation>Corrigez le reste dans le texte.</translation></message>
    <message><source>&amp;New…</source>
        <translation>&amp;Nouveau…</translation></message>
    <message><source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation></message>
    <message><source>&amp;Convert for another board…</source>
        <translation>&amp;Convertir pour une autre carte…</translation></message>
    <message><source>With another &amp;file…</source>
        <translation>Avec un autre &amp;fichier…</translation></message>
    <message><source>With the &amp;board</source>
        <translation>Avec la &amp;carte</translation></message>
    <message><source>With factory &amp;defaults</source>
        <translation>Avec les réglages d'&amp;usine</translation></message>
    <message><source>&amp;Send to the board…</source>
        <translation>&amp;Envoyer à la carte…</translation></message>
    <message><source>Not saved. {0}</source>
        <translation>Non enregistré. {0}</translation></message>
    <message><source>{0}[*] – TReX settings file</source>
        <translation>{0}[*] – Fichier de réglages TReX</translation></message>
    <message><source>Repaired: {0}.</source>
        <translation>Réparé : {0}.</translation></message>
    <message><source>Not compared. {0}</source>
        <translation>Non comparé. {0}</translation></message>
    <message><source>An autonomous robot: an on-board computer drives it, and no one is near enough to catch it</source>
        <translation>Un robot sans pilote : un ordinateur embarqué le conduit, et personne ne peut le rattraper</translation></message>
    <message><source>A rover driven by radio; a switch hands control to a computer</source>
        <translation>Un rover radiocommandé ; un interrupteur le confie à un ordinateur</translation></message>
    <message><source>A tank: two tracks, driven by radio with one stick</source>
        <translation>Un engin à deux chenilles, radiocommandé avec un seul manche</translation></message>
    <message><source>Factory defaults of a {0}, firmware {1}</source>
        <translation>Réglages d'usine d'un {0}, firmware {1}</translation></message>
    <message><source>&amp;Open settings file…</source>
        <translation>&amp;Ouvrir un fichier de réglages…</translation></message>
    <message><source>&amp;Start the new file with:</source>
        <translation>&amp;Commencer le nouveau fichier avec :</translation></message>
    <message><source>The board as shown: {0}, firmware {1}</source>
        <translation>La carte telle qu'affichée : {0}, firmware {1}</translation></message>
    <message><source>Applied</source>
        <translation>Appliqué</translation></message>
    <message><source>&amp;New settings file…</source>
        <translation>&amp;Nouveau fichier de réglages…</translation></message>
    <message><source>Initial contents</source>
        <translation>Points de départ</translation></message>
    <message><source>Settings applied {0}</source>
        <translation>Réglages appliqués {0}</translation></message>
    <message><source>Sample: {0}</source>
        <translation>Exemple : {0}</translation></message>
    <message><source>is not a readable settings file.</source>
        <translation>n'est pas un fichier de réglages lisible.</translation></message>
    <message><source>Calibrations that the board does not currently report remain in the file: {0}.</source>
        <translation>Les étalonnages que la carte n'affiche pas actuellement ont été conservés : {0}.</translation></message>
    <message><source>The program {0} applies and verifies the displayed settings. Its first lines explain how to use the program.</source>
        <translation>{0} applique et vérifie les réglages affichés ; lisez ses premières lignes.</translation></message>
    <message><source>{0} was not saved again: it is still being saved.</source>
        <translation>{0} n'a pas été enregistré une nouvelle fois : son enregistrement est encore en cours.</translation></message>
    <message><source>&amp;Export as code…</source>
        <translation>E&amp;xporter comme code…</translation></message>
    <message><source>The settings shown were saved in {0}.</source>
        <translation>Les réglages affichés ont été enregistrés dans {0}.</translation></message>
    <message><source>{0} was not saved: {1}</source>
        <translation>{0} n'a pas été enregistré : {1}</translation></message>
    <message><source>{0} was not written: {1}</source>
        <translation>{0} n'a pas été écrit : {1}</translation></message>
    <message><source>holds settings of a {0}.</source>
        <translation>contient les réglages d'un {0}.</translation></message>
    <message><source>Swap the wire pairs of motors 1 and 2. Keep the order within each pair.</source>
        <translation>Permutez la paire de fils du moteur 1 avec celle du moteur 2 (gardez leur ordre).</translation></message>
    <message><source>Swap the two wires of the left motor.</source>
        <translation>Permutez les deux fils du moteur gauche.</translation></message>
    <message><source>Swap the two wires of the right motor.</source>
        <translation>Permutez les deux fils du moteur droit.</translation></message>
    <message><source>No setting can make this change for serial commands, but your own program can.</source>
        <translation>Aucun réglage ne fait cela pour les commandes série ; votre propre programme peut s'en charger.</translation></message>
    <message><source>No setting of the board can make this change.</source>
        <translation>Aucun réglage de la carte ne fait cela.</translation></message>
    <message><source>Learning takes about two minutes, and the motors stay off. The next step needs the stick directions.</source>
        <translation>Environ deux minutes ; les moteurs restent à l'arrêt. L'étape suivante a besoin des directions.</translation></message>
    <message><source>The stick is fully &amp;right now</source>
        <translation>Le manche est poussé à fond vers la &amp;droite maintenant</translation></message>
    <message><source>The stick is fully &amp;forward now</source>
        <translation>Le manche est poussé à fond vers l'a&amp;vant maintenant</translation></message>
    <message><source>Both sticks are fully &amp;forward now</source>
        <translation>Les deux manches sont poussés à fond vers l'a&amp;vant maintenant</translation></message>
    <message><source>Wir&amp;es swapped – test again</source>
        <translation>Fils permutés – tester de &amp;nouveau</translation></message>
    <message><source>Clear both answers and test the motors again</source>
        <translation>Oublier les deux réponses et chercher à nouveau quel moteur est lequel</translation></message>
    <message><source>Nothing has to change: the wheels follow the sticks.</source>
        <translation>Rien n'est à changer : les roues suivent les manches.</translation></message>
    <message><source>Switch the motors' power off.</source>
        <translation>Coupez l'alimentation des moteurs.</translation></message>
    <message><source>The board learns your sticks</source>
        <translation>La carte apprend vos manches</translation></message>
    <message><source>Each channel is connected to an output of your receiver.</source>
        <translation>Chacune est reliée à une sortie de votre récepteur.</translation></message>
    <message><source>Channel 1 (motor 1)</source>
        <translation>Voie 1 (moteur 1)</translation></message>
    <message><source>Channel 2 (motor 2)</source>
        <translation>Voie 2 (moteur 2)</translation></message>
    <message><source>{0}: the direction is not known yet.</source>
        <translation>{0} : son sens n'est pas encore connu.</translation></message>
    <message><source>{0}: the value rises.</source>
        <translation>{0} : la valeur augmente.</translation></message>
    <message><source>{0}: the value falls.</source>
        <translation>{0} : la valeur diminue.</translation></message>
    <message><source>{0}: the stick is still near its centre. Push the stick all the way.</source>
        <translation>{0} : le manche est encore proche de son milieu. Poussez-le à fond.</translation></message>
    <message><source>Hold a button, then click what moved</source>
        <translation>Maintenez un bouton, puis cliquez sur ce qui a bougé</translation></message>
    <message><source>Nothing &amp;moved</source>
        <translation>Rien n'a &amp;bougé</translation></message>
    <message><source>Click what this motor moved</source>
        <translation>Cliquez sur ce que ce moteur a fait bouger</translation></message>
    <message><source>Nothing turned: the next pulses are stronger (30 %). If that does not help, check the battery and the wires of this motor.</source>
        <translation>Rien n'a tourné : les impulsions suivantes sont plus fortes (30 %). Si cela ne suffit pas, vérifiez la batterie et les fils de ce moteur.</translation></message>
    <message><source>Motor 1 drives the left wheel, motor 2 the right one, both forward.</source>
        <translation>Le moteur 1 entraîne la roue gauche, le moteur 2 la roue droite, tous deux vers l'avant.</translation></message>
    <message><source>No wires have to be swapped, but the directions of the sticks are not known yet: go back to Sticks. Your answers are kept.</source>
        <translation>Aucun fil n'est à permuter, mais les directions des manches ne sont pas encore connues : revenez à « Manches ». Vos réponses sont conservées.</translation></message>
    <message><source>Settings correct this; no wires have to be swapped.</source>
        <translation>Des réglages corrigent cela ; aucun fil n'est à permuter.</translation></message>
    <message><source>Already learned? Hold the sticks as a button says, then click the button:</source>
        <translation>Déjà appris ? Poussez, maintenez et cliquez :</translation></message>
    <message><source>Channel 1 (turns)</source>
        <translation>Voie 1 (tourne)</translation></message>
    <message><source>Channel 2 (drives)</source>
        <translation>Voie 2 (avance)</translation></message>
    <message><source>{0}: no signal arrives.</source>
        <translation>{0} : aucun signal n'arrive.</translation></message>
    <message><source>not tried yet</source>
        <translation>pas encore essayé</translation></message>
    <message><source>Nothing turned: the pulses stay below the speed ceiling of the Motors page. Raise the ceiling, or check the battery and the wires of this motor.</source>
        <translation>Rien n'a tourné : les impulsions restent sous la vitesse maximale de la page Moteurs. Augmentez-la, ou vérifiez la batterie et les fils de ce moteur.</translation></message>
    <message><source>Two motors cannot drive the same wheel: try both buttons again.</source>
        <translation>Deux moteurs ne peuvent pas entraîner la même roue : essayez à nouveau les deux boutons.</translation></message>
    <message><source>What did motor {0} move?</source>
        <translation>Qu'est-ce que le moteur {0} a fait bouger ?</translation></message>
    <message><source>Is the transmitter on?</source>
        <translation>L'émetteur est-il allumé ?</translation></message>
    <message><source>Motor &amp;{0}</source>
        <translation>Moteur &amp;{0}</translation></message>
    <message numerus="yes"><source>“Next” adds %n change(s). Nothing is written until you apply the changes.</source>
        <translation><numerusform>« Suivant » ajoute %n modification. Rien n'est écrit avant que vous ne l'appliquiez.</numerusform><numerusform>« Suivant » ajoute %n modifications. Rien n'est écrit avant que vous ne les appliquiez.</numerusform></translation></message>
    <message><source>&amp;Jumpers</source>
        <translation>&amp;Cavaliers</translation></message>
    <message><source>&amp;Sticks</source>
        <translation>&amp;Manches</translation></message>
    <message><source>&amp;Limits</source>
        <translation>&amp;Limites</translation></message>
    <message><source>T&amp;imeout</source>
        <translation>Déla&amp;i</translation></message>
    <message><source>You can skip any step. Nothing is written until you apply the changes at the end.</source>
        <translation>Chaque étape peut être passée. Rien n'est écrit avant que vous l'appliquiez à la fin.</translation></message>
    <message><source>Schematic drawing: see the user's guide for the positions on your board.</source>
        <translation>Schéma : le guide d'utilisation montre où ils se trouvent sur votre carte.</translation></message>
    <message><source>The mix jumper is on: remove it, then push a stick.</source>
        <translation>Le cavalier Mix est en place : retirez-le, puis poussez un manche.</translation></message>
    <message><source>The mix jumper is off: put it on, then push a stick.</source>
        <translation>Le cavalier Mix est retiré : mettez-le en place, puis poussez un manche.</translation></message>
    <message><source>Set the current that your motors can draw continuously; the presets are examples. Without a ramp, the current exceeds the limit for a moment.</source>
        <translation>Réglez ce que vos moteurs peuvent absorber en continu : les préréglages sont des exemples. Sans rampe, le courant dépasse la limite un instant.</translation></message>
    <message><source>The computer must send something at least twice within this time. UART-Error Shutdown is also switched on, because the timeout may need it (twin).</source>
        <translation>Faites envoyer quelque chose à l'ordinateur au moins deux fois pendant ce délai. « Arrêt sur erreur UART » est activé en même temps, car le délai peut en avoir besoin (jumeau).</translation></message>
    <message><source>The changes of this step were not added. Open the step and click Next.</source>
        <translation>Ses modifications n'ont pas été ajoutées : ouvrez l'étape et cliquez sur « Suivant ».</translation></message>
    <message><source>For the first drive, keep the wheels off the ground: forward, back, left, right.</source>
        <translation>Pilotez d'abord avec les roues décollées du sol : avant, arrière, gauche, droite.</translation></message>
    <message><source>Switch the board off, set the mode jumper to {0}, and {1}.</source>
        <translation>Coupez l'alimentation de la carte, placez le cavalier de mode sur {0}, {1}.</translation></message>
    <message><source>Switch on the transmitter, then the board.</source>
        <translation>Allumez l'émetteur, puis la carte.</translation></message>
    <message><source>The motors stay off until the sticks are released (safe-start).</source>
        <translation>Les moteurs restent arrêtés jusqu'à ce que les manches soient relâchés (démarrage sécurisé).</translation></message>
    <message><source>Who drives your robot?</source>
        <translation>Qui pilote votre robot ?</translation></message>
    <message><source>&amp;One stick</source>
        <translation>&amp;Un manche</translation></message>
    <message><source>&amp;Two sticks</source>
        <translation>&amp;Deux manches</translation></message>
    <message><source>&amp;A computer</source>
        <translation>Un &amp;ordinateur</translation></message>
    <message><source>One stick drives and turns. The board mixes both.</source>
        <translation>Un seul manche avance et tourne. La carte mélange les deux.</translation></message>
    <message><source>One stick for each side of the robot, as in a tank.</source>
        <translation>Un manche pour chaque côté du robot, comme sur un char.</translation></message>
    <message><source>Commands come over the serial line.</source>
        <translation>Les commandes arrivent par la liaison série.</translation></message>
    <message><source>Move the jumpers as drawn</source>
        <translation>Placez les cavaliers comme sur le dessin</translation></message>
    <message><source>How should the motors start and stop?</source>
        <translation>Comment les moteurs doivent-ils démarrer et s'arrêter ?</translation></message>
    <message><source>As &amp;it is</source>
        <translation>I&amp;nchangé</translation></message>
    <message><source>&amp;Tank</source>
        <translation>&amp;Char</translation></message>
    <message><source>Ro&amp;ver</source>
        <translation>&amp;Rover</translation></message>
    <message><source>&amp;Autonomous robot</source>
        <translation>Robot &amp;autonome</translation></message>
    <message><source>off</source><comment>limit</comment>
        <translation>désactivée</translation></message>
    <message><source>In joint mode the board does not measure the current and cannot limit it.</source>
        <translation>En mode jumelé, la carte ne mesure aucun courant et ne peut donc pas le limiter.</translation></message>
    <message><source>This example was made for a {0}, which measures current in other units. Your board keeps its current limit.</source>
        <translation>Cet exemple a été fait pour un {0}, qui mesure le courant dans d'autres unités. Votre carte garde sa limite de courant.</translation></message>
    <message><source>If the cable falls out, the board stops</source>
        <translation>Si le câble se débranche, la carte s'arrête</translation></message>
    <message><source>What is left to do</source>
        <translation>Ce qu'il reste à faire</translation></message>
    <message><source>The positions are wrong or have not been checked.</source>
        <translation>Mauvaises positions, ou non vérifiées.</translation></message>
    <message><source>The directions of the sticks are not known.</source>
        <translation>Les sens des manches ne sont pas connus.</translation></message>
    <message><source>This step was skipped, or its changes were undone.</source>
        <translation>Étape passée, ou ses modifications ont été annulées.</translation></message>
    <message><source>It is not known which motor drives which wheel.</source>
        <translation>On ne sait pas quel moteur entraîne quelle roue.</translation></message>
    <message><source>The motor settings depend on the directions of the sticks.</source>
        <translation>Les réglages des moteurs attendent les sens des manches.</translation></message>
    <message><source>Leave the mode jumper off. You can send the first commands from the Motors page of this window.</source>
        <translation>Laissez le cavalier de mode retiré. Les premières commandes peuvent venir de la page Moteurs de cette fenêtre.</translation></message>
    <message><source>put the mix jumper on</source>
        <translation>mettez le cavalier Mix</translation></message>
    <message><source>leave the mix jumper off</source>
        <translation>laissez le cavalier Mix retiré</translation></message>
    <message><source>The board does not respond: it may be switched off.</source>
        <translation>La carte ne répond pas : elle est peut-être hors tension.</translation></message>
    <message><source>No board is connected, so its jumpers cannot be checked.</source>
        <translation>Aucune carte n'est connectée : ses cavaliers ne peuvent pas être vérifiés.</translation></message>
    <message><source>This board was started without the mode jumper (serial mode).</source>
        <translation>Cette carte a démarré sans le cavalier de mode (mode série).</translation></message>
    <message><source>The mix jumper can be checked only in serial mode. In the present mode, a stick would drive the motors.</source>
        <translation>Le cavalier Mix ne peut être vérifié qu'en mode série : maintenant, un manche ferait tourner les moteurs.</translation></message>
    <message><source>The board does not report the state of the mix jumper. Push a stick to one side to detect it.</source>
        <translation>La carte ne signale pas le cavalier Mix. Poussez un manche d'un côté pour le voir.</translation></message>
    <message><source>Current &amp;limit of each motor</source>
        <translation>&amp;Limite de courant de chaque moteur</translation></message>
    <message><source>&amp;Stop the motors after a silence of</source>
        <translation>&amp;Arrêter les moteurs après un silence de</translation></message>
    <message><source>Go to this step</source>
        <translation>Aller à cette étape</translation></message>
    <message><source>Then, by hand:</source>
        <translation>Ensuite, à la main :</translation></message>
    <message><source>The mix jumper is on.</source>
        <translation>Le cavalier Mix est en place.</translation></message>
    <message><source>The mix jumper is off.</source>
        <translation>Le cavalier Mix est retiré.</translation></message>
    <message><source>{0} Then test the motors again.</source>
        <translation>{0} Testez ensuite à nouveau les moteurs.</translation></message>
    <message><source>Select a snapshot to see what it would restore.</source>
        <translation>Sélectionnez un instantané pour voir ce qu'il restaurerait.</translation></message>
    <message><source>This snapshot is from a {0}, but the connected board is a {1}. The snapshot cannot be restored.</source>
        <translation>Cet instantané est celui d'un {0}, et la carte ici est un {1} : il ne peut pas être restauré.</translation></message>
    <message><source>Note: this snapshot is from device number {0}, and the connected board has number {1}.</source>
        <translation>Remarque : cet instantané est celui du numéro d'appareil {0}, la carte ici porte le numéro {1}.</translation></message>
    <message><source>Now, with edits</source>
        <translation>Maintenant, avec les modifications</translation></message>
    <message><source>Reading…</source>
        <translation>Lecture…</translation></message>
    <message><source>{0}, before {1}</source>
        <translation>{0}, avant : {1}</translation></message>
    <message numerus="yes"><source>&amp;Restore %n setting(s)…</source>
        <translation><numerusform>&amp;Restaurer %n réglage…</numerusform><numerusform>&amp;Restaurer %n réglages…</numerusform></translation></message>
    <message><source>Nothing is selected for restoring.</source>
        <translation>Rien n'est sélectionné pour la restauration.</translation></message>
    <message><source>To restore a snapshot, select only this snapshot.</source>
        <translation>Pour restaurer l'un des deux, sélectionnez-le seul.</translation></message>
    <message><source>The board does not respond, so nothing can be restored.</source>
        <translation>La carte ne répond pas : rien ne peut être restauré.</translation></message>
    <message><source>Settings are being written. Wait until writing ends.</source>
        <translation>Des réglages sont en cours d'écriture ; attendez la fin.</translation></message>
    <message><source>No board is connected. Connect one to restore a snapshot.</source>
        <translation>Aucune carte n'est connectée. Connectez-en une pour restaurer un instantané.</translation></message>
    <message><source>Select one snapshot, or two to compare them.</source>
        <translation>Sélectionnez un instantané, ou deux pour les comparer.</translation></message>
    <message><source>Restore snapshot of {0}</source>
        <translation>Restaurer l'instantané ({0})</translation></message>
    <message><source>No setting differs.</source>
        <translation>Aucun réglage ne diffère.</translation></message>
    <message><source>Nothing was restored: {0}</source>
        <translation>Rien n'a été restauré : {0}</translation></message>
    <message><source>Never connect RS-232 levels (±12 V) to SI and SO: they can destroy the board.</source>
        <translation>Ne reliez jamais des niveaux RS-232 (±12 V) à SI et SO : ils peuvent détruire la carte.</translation></message>
    <message><source>Set the board up through an adapter first: with the mode jumper on, it accepts no settings. BEC supplies at most 100 mA.</source>
        <translation>Configurez d'abord la carte par un adaptateur : quand le cavalier de mode est en place, elle n'accepte aucun réglage. Le BEC fournit 100 mA au plus.</translation></message>
    <message><source>TReX</source>
        <translation>TReX</translation></message>
    <message><source>RS-232 port</source>
        <translation>Port RS-232</translation></message>
    <message><source>Receiver</source>
        <translation>Récepteur</translation></message>
    <message><source>Switch off the motor supply, or put the robot on blocks. Connecting and searching do not move a motor.</source>
        <translation>Coupez l'alimentation des moteurs ou posez le robot sur cales. Connecter et rechercher ne font tourner aucun moteur.</translation></message>
    <message><source>No board at hand?</source>
        <translation>Pas de carte sous la main ?</translation></message>
    <message><source>&amp;Try the demo</source>
        <translation>&amp;Essayer la démo</translation></message>
    <message><source>Mode: remove it</source>
        <translation>Mode : le retirer</translation></message>
    <message><source>SO–G: remove it</source>
        <translation>SO–G : le retirer</translation></message>
    <message><source>Mode: set it to RC</source>
        <translation>Mode : le placer sur RC</translation></message>
    <message><source>BEC: feeds the receiver</source>
        <translation>BEC : alimente le récepteur</translation></message>
    <message><source>USB adapter, 3.3 or 5 V</source>
        <translation>Adaptateur USB, 3,3 ou 5 V</translation></message>
    <message><source>RS-&amp;232 adapter</source>
        <translation>Adaptateur RS-&amp;232</translation></message>
    <message><source>RC recei&amp;ver</source>
        <translation>&amp;Récepteur RC</translation></message>
    <message><source>Open &amp;settings file…</source>
        <translation>Ouvrir un fichier de réglage&amp;s…</translation></message>
    <message><source>&amp;Open recording…</source>
        <translation>&amp;Ouvrir un enregistrement…</translation></message>
    <message><source>Go on without the changes of this step</source>
        <translation>Continuer sans les modifications de cette étape</translation></message>
    <message><source>&amp;Back</source>
        <translation>Précéden&amp;t</translation></message>
    <message><source>S&amp;kip</source>
        <translation>&amp;Passer</translation></message>
    <message><source>Plot of currents in its o&amp;wn window</source>
        <translation>Courbes des courants dans une &amp;fenêtre séparée</translation></message>
    <message><source>Demo TReX</source>
        <translation>Démo TReX</translation></message>
    <message><source>a settings file of a TReX</source>
        <translation>un fichier de réglages d'un TReX</translation></message>
    <message><source>a board</source>
        <translation>une carte</translation></message>
    <message><source>B&amp;oard</source>
        <translation>C&amp;arte</translation></message>
    <message><source>&amp;Channels</source>
        <translation>&amp;Voies</translation></message>
    <message><source>&amp;Motors</source>
        <translation>&amp;Moteurs</translation></message>
    <message><source>&amp;Parameters</source>
        <translation>&amp;Paramètres</translation></message>
    <message><source>&amp;Discard all edits</source>
        <translation>Abandonner toutes les &amp;modifications</translation></message>
    <message><source>R&amp;eload settings from device</source>
        <translation>Recharg&amp;er les réglages de l'appareil</translation></message>
    <message><source>Review ch&amp;anges…</source>
        <translation>Vérifier et appli&amp;quer…</translation></message>
    <message><source>Make stored settings acti&amp;ve…</source>
        <translation>Rendre acti&amp;fs les réglages enregistrés…</translation></message>
    <message><source>Find &amp;other boards on this line</source>
        <translation>Rechercher d'autres cartes sur cette liais&amp;on</translation></message>
    <message><source>A&amp;pply a file to several boards…</source>
        <translation>Appliquer un fichier à &amp;plusieurs cartes…</translation></message>
    <message><source>Set up one board after anot&amp;her…</source>
        <translation>Confi&amp;gurer des cartes l'une après l'autre…</translation></message>
    <message><source>Lear&amp;n channels…</source>
        <translation>Apprendre les &amp;voies…</translation></message>
    <message><source>&amp;Demo TReX panel</source>
        <translation>Panneau &amp;Démo TReX</translation></message>
    <message><source>&amp;User's guide of the board (online)…</source>
        <translation>&amp;Guide d'utilisation de la carte (en ligne)…</translation></message>
    <message><source>Gamepads need one more package. Install the package with {0}, then switch Gamepad on again.</source>
        <translation>Les manettes nécessitent un paquet supplémentaire. Installez-le avec {0}, puis réactivez cette option.</translation></message>
    <message><source>Gamepads cannot be read on this computer: {0}.</source>
        <translation>Les manettes ne peuvent pas être lues ici : {0}.</translation></message>
    <message><source>The program was suspended (Ctrl-Z)</source>
        <translation>Le programme a été suspendu (Ctrl-Z)</translation></message>
    <message><source>Internal error ({0})</source>
        <translation>Erreur interne ({0})</translation></message>
    <message><source>The computer was asleep</source>
        <translation>L'ordinateur était en veille</translation></message>
    <message><source>Stopping the motors before the computer sleeps</source>
        <translation>Les moteurs qui peuvent être arrêtés le sont avant la mise en veille de l'ordinateur</translation></message>
    <message><source>The screen was locked</source>
        <translation>L'écran a été verrouillé</translation></message>
    <message><source>The computer is going to sleep</source>
        <translation>L'ordinateur se met en veille</translation></message>
    <message><source>The computer is shutting down</source>
        <translation>L'ordinateur s'éteint</translation></message>
    <message><source>The session is ending</source>
        <translation>La session se termine</translation></message>
    <message><source>Reconnected to {0}. No motor was started.</source>
        <translation>De nouveau connecté à {0}. Aucun moteur n'a été démarré.</translation></message>
    <message><source>{0} also has {1} open and may take replies. Close the port there.</source>
        <translation>{0} a aussi ouvert {1} et peut intercepter des réponses. Fermez-le dans ce programme.</translation></message>
    <message><source>Connecting to {0} …</source>
        <translation>Connexion à {0} …</translation></message>
    <message><source>Disconnecting …</source>
        <translation>Déconnexion …</translation></message>
    <message><source>The cable of the Demo {0} is unplugged. Plug the cable in on the demo panel, then connect again.</source>
        <translation>Le câble de la démo {0} est débranché. Branchez-le sur son panneau, puis reconnectez.</translation></message>
    <message><source>Replies lost</source>
        <translation>Réponses perdues</translation></message>
    <message><source>Noise on the line</source>
        <translation>Bruit sur la liaison</translation></message>
    <message><source>The Demo {0} is not running. Press Connect.</source>
        <translation>La démo {0} n'est pas en marche. Cliquez sur « Connecter ».</translation></message>
    <message><source>The cable is unplugged. Plug it in, then press Connect.</source>
        <translation>Le câble est débranché. Branchez-le, puis cliquez sur « Connecter ».</translation></message>
    <message><source>The cable is plugged in again. Press Connect.</source>
        <translation>Le câble est de nouveau branché. Cliquez sur « Connecter ».</translation></message>
    <message><source>The Demo {0} is starting …</source>
        <translation>La démo {0} démarre …</translation></message>
    <message><source>The power is off. Switch it on, then press Connect.</source>
        <translation>L'alimentation est coupée. Remettez-la, puis cliquez sur « Connecter ».</translation></message>
    <message><source>Demo {0} (no hardware)</source>
        <translation>Démo {0} (sans matériel)</translation></message>
    <message><source>Ending the search …</source>
        <translation>Fin de la recherche …</translation></message>
    <message><source>Looking for {0} at {1} on {2} …</source>
        <translation>Recherche : {0} à {1} sur {2} …</translation></message>
    <message><source>{0} on {1} at {2} (RS-232 side).</source>
        <translation>{0} sur {1} à {2} (côté RS-232).</translation></message>
    <message><source>{0} on {1} at {2}.</source>
        <translation>{0} sur {1} à {2}.</translation></message>
    <message><source>Search cancelled.</source>
        <translation>Recherche annulée.</translation></message>
    <message numerus="yes"><source>%n board(s) found.</source>
        <translation><numerusform>%n carte trouvée.</numerusform><numerusform>%n cartes trouvées.</numerusform></translation></message>
    <message><source>No board was found.</source>
        <translation>Aucune carte n'a été trouvée.</translation></message>
    <message><source>Opening {0} …</source>
        <translation>Ouverture de {0} …</translation></message>
    <message><source>No reply on {0}. No other settings were tried, because other devices share the line.</source>
        <translation>Pas de réponse sur {0}. D'autres appareils partagent la liaison : rien d'autre n'a été essayé.</translation></message>
    <message><source>{0} with device number {1}</source>
        <translation>{0} avec le numéro d'appareil {1}</translation></message>
    <message><source>the Demo {0}</source>
        <translation>la démo {0}</translation></message>
    <message><source>The simulator could not be started. Reinstall the program.</source>
        <translation>Le simulateur ne démarre pas. Réinstallez le programme.</translation></message>
    <message><source>The simulator exited immediately. {0}</source>
        <translation>Le simulateur s'est terminé aussitôt. {0}</translation></message>
    <message><source>&amp;Undo {0}</source>
        <translation>&amp;Annuler : {0}</translation></message>
    <message><source>&amp;Redo {0}</source>
        <translation>&amp;Rétablir : {0}</translation></message>
    <message><source>Show help for the message at the cursor</source>
        <translation>Afficher l'aide sur le message de la ligne où se trouve le curseur</translation></message>
    <message><source>Search (Ctrl+F)</source>
        <translation>Rechercher (Ctrl+F)</translation></message>
    <message><source>Copy the selected rows, or everything shown</source>
        <translation>Copier les lignes sélectionnées, ou tout ce qui est affiché</translation></message>
    <message><source>Save a report for support; it is shown before it is written</source>
        <translation>Enregistrer un rapport pour l'assistance ; il est d'abord affiché</translation></message>
    <message><source>O&amp;nly problems</source>
        <translation>Problèmes &amp;seulement</translation></message>
    <message><source>E&amp;xplain</source>
        <translation>&amp;Expliquer</translation></message>
    <message><source>Messages, stops, lost connections and written settings will be listed here.</source>
        <translation>Les messages, les arrêts, les connexions perdues et les réglages écrits apparaîtront ici.</translation></message>
    <message><source>Diagnostics</source>
        <translation>Diagnostic</translation></message>
    <message><source>Cop&amp;y</source>
        <translation>&amp;Copier</translation></message>
    <message><source>Sa&amp;ve report…</source>
        <translation>Enre&amp;gistrer un rapport…</translation></message>
    <message><source>Lo&amp;g</source>
        <translation>&amp;Journal</translation></message>
    <message><source>T&amp;raffic</source>
        <translation>&amp;Trafic</translation></message>
    <message><source>{0} of {1} shown</source>
        <translation>{0} sur {1} affichées</translation></message>
    <message><source>Round trips in the last minute: up to {0:.0f} ms</source>
        <translation>Temps de réponse de la dernière minute : jusqu'à {0:.0f} ms</translation></message>
    <message><source>Nothing has gone wrong since {0:%H:%M}.</source>
        <translation>Aucun problème depuis {0:%H:%M}.</translation></message>
    <message><source>Connection</source>
        <translation>Connexion</translation></message>
    <message><source>Nothing is connected.</source>
        <translation>Rien n'est connecté.</translation></message>
    <message numerus="yes"><source>%n problem(s) active now</source>
        <translation><numerusform>%n problème actif</numerusform><numerusform>%n problèmes actifs</numerusform></translation></message>
    <message><source>Nothing else has gone wrong since {0:%H:%M}.</source>
        <translation>Aucun autre problème depuis {0:%H:%M}.</translation></message>
    <message numerus="yes"><source>%n time(s), last at {0:%H:%M:%S}</source>
        <translation><numerusform>%n fois, à {0:%H:%M:%S}</numerusform><numerusform>%n fois, la dernière à {0:%H:%M:%S}</numerusform></translation></message>
    <message><source>Show it</source>
        <translation>Montrer</translation></message>
    <message><source>C&amp;lear</source>
        <translation>&amp;Effacer</translation></message>
    <message><source>the name of a picture needs a file extension such as .png</source>
        <translation>les images doivent avoir une extension telle que .png</translation></message>
    <message><source>pictures cannot be written as {0}</source>
        <translation>les images ne peuvent pas être écrites au format {0}</translation></message>
    <message><source>F&amp;ind…</source>
        <translation>Rec&amp;hercher…</translation></message>
    <message><source>Set up CRC…</source>
        <translation>Configurer le CRC…</translation></message>
    <message><source>Progress</source>
        <translation>Progression</translation></message>
    <message><source>A device such as /dev/ttyUSB0 or COM3, or a network port such as socket://host:port or rfc2217://host:port:</source>
        <translation>Un périphérique comme /dev/ttyUSB0 ou COM3, ou un port réseau comme socket://hôte:port ou rfc2217://hôte:port :</translation></message>
    <message><source>Dis&amp;connect</source>
        <translation>Déconnec&amp;ter</translation></message>
    <message><source>&amp;Port:</source>
        <translation>&amp;Port :</translation></message>
    <message><source>How this computer talks to the board</source>
        <translation>Comment cet ordinateur communique avec la carte</translation></message>
    <message><source>Find a board whose line settings are unknown</source>
        <translation>Rechercher une carte dont les réglages de liaison sont inconnus</translation></message>
    <message><source>Let the board detect corrupted bytes; the changes are shown before they are written</source>
        <translation>Laisser la carte détecter les octets altérés ; montre d'abord ce qui sera écrit</translation></message>
    <message><source>Settings are still being written. Disconnect anyway? Unwritten settings stay pending.</source>
        <translation>Des réglages sont encore en cours d'écriture. Déconnecter quand même ? Les réglages non écrits restent en attente.</translation></message>
    <message><source>Other port or address…</source>
        <translation>Autre port ou adresse…</translation></message>
    <message><source>Not connected</source>
        <translation>Pas connecté</translation></message>
    <message><source>&amp;Find a board…</source>
        <translation>Rec&amp;hercher une carte…</translation></message>
    <message><source>Starting the Demo {0} …</source>
        <translation>Démarrage de la démo {0} …</translation></message>
    <message><source>&amp;Disconnect</source>
        <translation>Déco&amp;nnecter</translation></message>
    <message><source>{0} was not opened: its type is not supported. Supported: {1}.</source>
        <translation>{0} n'a pas été ouvert : ce type n'est pas pris en charge. Pris en charge : {1}.</translation></message>
    <message><source>Recent &amp;files</source>
        <translation>&amp;Fichiers récents</translation></message>
    <message><source>None of the {0} dropped files was opened. Drop one file at a time.</source>
        <translation>{0} fichiers ont été déposés et aucun n'a été ouvert : déposez-en un à la fois.</translation></message>
    <message><source>{0} is {1}. It was not opened, because this window is connected to {2}: disconnect, then open it again.</source>
        <translation>{0} est {1}. Il n'a pas été ouvert, car cette fenêtre est connectée à {2} : déconnectez, puis ouvrez-le à nouveau.</translation></message>
    <message><source>{0} no longer exists and was removed from the recent files.</source>
        <translation>{0} n'existe plus ; il a été retiré des fichiers récents.</translation></message>
    <message><source>a file of the {0}</source>
        <translation>un fichier pour {0}</translation></message>
    <message><source>Probes each port for every supported device, first at its likely settings, then at every baud rate, with every parity and with CRC. Probes never move a motor or change a setting of a TReX or an Aracna. Other devices on the line may react: enter their numbers in the line settings first. A TReX that receives probes at another rate counts UART errors, and stops its motors if it is set to do so.</source>
        <translation>Sonde chaque port à la recherche d'un appareil pris en charge : chaque type avec ses réglages probables, puis à tous les débits, avec toutes les parités et avec CRC. Un TReX ou un Aracna ne fait alors bouger aucun moteur et ne change aucun réglage. D'autres appareils sur la liaison le peuvent : entrez d'abord leurs numéros dans les réglages de liaison. Un TReX qui reçoit ces sondages à un autre débit compte des erreurs UART, et arrête ses moteurs s'il est réglé ainsi.</translation></message>
    <message><source>The likely settings come first; a port without a reply takes about half a minute.</source>
        <translation>Les réglages probables viennent d'abord ; un port sans réponse demande environ une demi-minute.</translation></message>
    <message><source>&amp;Full search: also try every CRC polynomial and every device number (takes a few minutes)</source>
        <translation>Recherche &amp;complète : aussi chaque polynôme CRC et chaque numéro d'appareil (quelques minutes)</translation></message>
    <message><source>C&amp;ancel</source>
        <translation>&amp;Annuler</translation></message>
    <message><source>C&amp;heck the board…</source>
        <translation>&amp;Vérifier la carte…</translation></message>
    <message><source>{0} – connected to this window</source>
        <translation>{0} – connecté à cette fenêtre</translation></message>
    <message><source>{0} is connected to this window, so it is not searched.</source>
        <translation>{0} est connecté à cette fenêtre et n'est donc pas exploré.</translation></message>
    <message><source>Found devices</source>
        <translation>Appareils trouvés</translation></message>
    <message><source>What the LEDs mean, how to wire the board, and how to restore serial settings</source>
        <translation>La signification des LED, le câblage et comment restaurer les réglages série</translation></message>
    <message><source>Copy command</source>
        <translation>Copier la commande</translation></message>
    <message><source>Search &amp;on:</source>
        <translation>&amp;Rechercher sur :</translation></message>
    <message><source>This computer has no serial ports. Plug in an adapter.</source>
        <translation>Cet ordinateur n'a pas de port série. Branchez un adaptateur.</translation></message>
    <message><source>Connect to {0}</source>
        <translation>Connecter à {0}</translation></message>
    <message><source>Help</source>
        <translation>Aide</translation></message>
    <message><source>TReX Studio</source>
        <translation>TReX Studio</translation></message>
    <message><source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation></message>
    <message><source>E&amp;xit</source>
        <translation>&amp;Quitter</translation></message>
    <message><source>Search every&amp;thing</source>
        <translation>&amp;Tout rechercher</translation></message>
    <message><source>&amp;Help</source>
        <translation>A&amp;ide</translation></message>
    <message><source>&amp;Save report for support…</source>
        <translation>&amp;Enregistrer un rapport d'assistance…</translation></message>
    <message><source>&amp;About</source>
        <translation>À &amp;propos</translation></message>
    <message><source>{0} on {1}</source>
        <translation>{0} sur {1}</translation></message>
    <message><source>{0} (demo)</source>
        <translation>{0} (démo)</translation></message>
    <message><source>The window is closing</source>
        <translation>La fenêtre allait être fermée</translation></message>
    <message><source>&amp;Window</source>
        <translation>Fe&amp;nêtre</translation></message>
    <message><source>As the system</source>
        <translation>Comme le système</translation></message>
    <message><source>Light</source>
        <translation>Clair</translation></message>
    <message><source>Dark</source>
        <translation>Sombre</translation></message>
    <message><source>High contrast</source>
        <translation>Contraste élevé</translation></message>
    <message><source>Physical units (µs, V, %, s)</source>
        <translation>Unités physiques (µs, V, %, s)</translation></message>
    <message><source>Values of the board (counts, 0 to 127)</source>
        <translation>Valeurs de la carte (counts, 0 à 127)</translation></message>
    <message><source>&amp;Theme:</source>
        <translation>&amp;Thème :</translation></message>
    <message><source>&amp;Font size:</source>
        <translation>Taille de &amp;police :</translation></message>
    <message><source>&amp;Language:</source>
        <translation>&amp;Langue :</translation></message>
    <message><source>Takes effect the next time the program starts</source>
        <translation>Prend effet au prochain démarrage du programme</translation></message>
    <message><source>&amp;Units:</source>
        <translation>&amp;Unités :</translation></message>
    <message><source>Determines which unit is shown first, and which unit applies to a number typed without one</source>
        <translation>Ce qui est affiché en premier, et ce que signifie un nombre tapé sans unité</translation></message>
    <message><source>Connect to known boards automat&amp;ically</source>
        <translation>Connecter &amp;automatiquement les cartes connues</translation></message>
    <message><source>The program connects when it starts or when a known adapter is plugged in, if exactly one board responds. It does not connect after Disconnect or while another program uses the port. No motor moves.</source>
        <translation>Au démarrage du programme et au branchement d'un adaptateur où une carte a déjà été trouvée, si une seule carte répond. Pas après « Déconnecter », ni tant qu'un autre programme utilise le port. Aucun moteur ne bouge.</translation></message>
    <message><source>{0} %</source>
        <translation>{0} %</translation></message>
    <message><source>The report contains only what is shown here. It is only saved as a file, never sent. Names of users and computers, network addresses and serial numbers of adapters are masked. Clear the check box of a file to leave it out.</source>
        <translation>Voici ce que contient le rapport, et rien d'autre. Il est seulement enregistré dans un fichier, jamais envoyé. Les noms d'utilisateurs et d'ordinateurs, les adresses réseau et les numéros de série des adaptateurs sont masqués. Décochez un fichier pour l'exclure.</translation></message>
    <message><source>Collecting …</source>
        <translation>Collecte …</translation></message>
    <message><source>&amp;Save…</source>
        <translation>&amp;Enregistrer…</translation></message>
    <message><source>Zip archives (*.zip)</source>
        <translation>Archives zip (*.zip)</translation></message>
    <message><source>Files of the report</source>
        <translation>Fichiers du rapport</translation></message>
    <message><source>Content of the file</source>
        <translation>Contenu du fichier</translation></message>
    <message><source>&amp;Files:</source>
        <translation>Fic&amp;hiers :</translation></message>
    <message><source>Con&amp;tent:</source>
        <translation>&amp;Contenu :</translation></message>
    <message><source>The report was written to {0}.</source>
        <translation>Le rapport a été écrit dans {0}.</translation></message>
    <message><source>{0} ({1} bytes)</source>
        <translation>{0} ({1} octets)</translation></message>
    <message><source>Search everything (Ctrl+K)</source>
        <translation>Tout rechercher (Ctrl+K)</translation></message>
    <message><source>Nothing was found.</source>
        <translation>Rien n'a été trouvé.</translation></message>
    <message><source>Hits</source>
        <translation>Résultats</translation></message>
    <message><source>Search every port and baud rate; no motor moves</source>
        <translation>Explorer tous les ports et tous les débits ; aucun moteur ne bouge</translation></message>
    <message><source>A simulated board: nothing can be damaged</source>
        <translation>Une carte simulée : rien ne peut être endommagé</translation></message>
    <message><source>What is plugged in</source>
        <translation>Ce qui est branché</translation></message>
    <message><source>No serial port was found. Plug in the adapter, and it will be listed here at once.</source>
        <translation>Aucun port série n'a été trouvé. Branchez l'adaptateur : il apparaît ici aussitôt.</translation></message>
    <message><source>No response?</source>
        <translation>Pas de réponse ?</translation></message>
    <message><source>Find &amp;my board…</source>
        <translation>Rechercher ma &amp;carte…</translation></message>
    <message><source>Close the window</source>
        <translation>Fermer la fenêtre</translation></message>
    <message><source>Pages of the help</source>
        <translation>Pages de l'aide</translation></message>
    <message><source>The program could not stop the motors itself. The guardian process sent a stop at {0}, but the board did not confirm the stop. If a motor is still turning, cut its power.</source>
        <translation>Le programme n'a pas pu arrêter les moteurs lui-même. Le processus gardien a envoyé à {0} un ordre d'arrêt que la carte n'a pas confirmé. Si un moteur tourne encore, coupez son alimentation.</translation></message>
    <message><source>The program could not stop the motors itself. The guardian process stopped them at {0}, and the board confirmed the stop.</source>
        <translation>Le programme n'a pas pu arrêter les moteurs lui-même. Le processus gardien les a arrêtés à {0} et la carte l'a confirmé.</translation></message>
    <message><source>TReX Studio did not end properly last time. If it crashed, the support report shows where.</source>
        <translation>TReX Studio ne s'est pas terminé correctement la dernière fois. S'il a planté, un rapport d'assistance indique où.</translation></message>
    <message><source>End the recording; motors and connection are not affected</source>
        <translation>Terminer l'enregistrement ; les moteurs et la connexion ne sont pas touchés</translation></message>
    <message><source>Recorded to {0} ({1}). Use {2} to view it.</source>
        <translation>Enregistré dans {0} ({1}). {2} l'affiche.</translation></message>
    <message><source>{0} is open; close its window before you overwrite it.</source>
        <translation>{0} est ouvert ; fermez sa fenêtre avant d'enregistrer par-dessus.</translation></message>
    <message><source>Save a cop&amp;y…</source>
        <translation>Enregistrer une cop&amp;ie…</translation></message>
    <message><source>Recording</source>
        <translation>Enregistrement</translation></message>
    <message><source>Recording  {0}  {1}</source>
        <translation>Enregistrement  {0}  {1}</translation></message>
    <message numerus="yes"><source>%n sample(s) lost: the disk is too slow</source>
        <translation><numerusform>%n échantillon perdu : le disque est trop lent</numerusform><numerusform>%n échantillons perdus : le disque est trop lent</numerusform></translation></message>
    <message><source>Recordings (*{0})</source>
        <translation>Enregistrements (*{0})</translation></message>
    <message><source>Playback speed</source>
        <translation>Vitesse de lecture</translation></message>
    <message><source>Time in the recording</source>
        <translation>Instant dans l'enregistrement</translation></message>
    <message><source>&amp;Pause</source>
        <translation>&amp;Pause</translation></message>
    <message><source>&amp;Play</source>
        <translation>&amp;Lecture</translation></message>
    <message><source>Show the whole recording again</source>
        <translation>Afficher de nouveau tout l'enregistrement</translation></message>
    <message><source>Save every sample in the plot as CSV or MCAP</source>
        <translation>Enregistrer chaque échantillon du graphique en CSV ou MCAP</translation></message>
    <message><source>Save a copy, because old recordings of faults and stops are removed automatically</source>
        <translation>Conserver cet enregistrement : les plus anciens enregistrements de défauts et d'arrêts sont supprimés</translation></message>
    <message><source>Stop loading or exporting</source>
        <translation>Arrêter le chargement ou l'exportation</translation></message>
    <message><source>Exporting, %p %</source>
        <translation>Exportation, %p %</translation></message>
    <message><source>Reading, %p %</source>
        <translation>Lecture, %p %</translation></message>
    <message><source>This recording has no events.</source>
        <translation>Cet enregistrement n'a aucun événement.</translation></message>
    <message><source>This recording is not complete. {0}</source>
        <translation>Cet enregistrement n'est pas complet. {0}</translation></message>
    <message><source>CSV for spreadsheets (*.csv)</source>
        <translation>CSV pour tableurs (*.csv)</translation></message>
    <message><source>MCAP for PlotJuggler and Foxglove (*.mcap)</source>
        <translation>MCAP pour PlotJuggler et Foxglove (*.mcap)</translation></message>
    <message><source>The open recording cannot be overwritten. Select another file.</source>
        <translation>L'enregistrement ouvert ne peut pas être écrasé. Choisissez un autre fichier.</translation></message>
    <message><source>E&amp;vents</source>
        <translation>É&amp;vénements</translation></message>
    <message><source>&amp;Export span…</source>
        <translation>&amp;Exporter la plage…</translation></message>
    <message><source>{0}, recorded {1}</source>
        <translation>{0}, enregistré {1}</translation></message>
    <message><source>{0} – recording</source>
        <translation>{0} – enregistrement</translation></message>
    <message><source>The span was saved to {0}.</source>
        <translation>La plage a été enregistrée dans {0}.</translation></message>
    <message><source>{0}, {1} long</source>
        <translation>{0}, durée {1}</translation></message>
    <message><source>Show &amp;all</source>
        <translation>&amp;Tout afficher</translation></message>
    <message><source>Exporting MCAP requires an optional package. Install it with: {0}</source>
        <translation>L'exportation MCAP nécessite un paquet facultatif. Installez-le avec : {0}</translation></message>
    <message><source>The curves show the last {0} of {1} samples. Exports contain all samples.</source>
        <translation>Les courbes montrent les {0} derniers échantillons sur {1} ; les exportations les contiennent tous.</translation></message>
    <message><source>{n} h</source>
        <translation>{n} h</translation></message>
    <message><source>{n} s</source>
        <translation>{n} s</translation></message>
    <message><source>{n} min</source>
        <translation>{n} min</translation></message>
    <message><source>now</source>
        <translation>maintenant</translation></message>
    <message><source>Low</source>
        <translation>Min.</translation></message>
    <message><source>Peak</source>
        <translation>Crête</translation></message>
    <message><source>Mean</source>
        <translation>Moyenne</translation></message>
    <message><source>RMS</source>
        <translation>RMS</translation></message>
    <message><source>Picture as &amp;PNG…</source>
        <translation>Image &amp;PNG…</translation></message>
    <message><source>Picture as &amp;SVG…</source>
        <translation>&amp;Image SVG…</translation></message>
    <message><source>Pictures on a &amp;light background</source>
        <translation>Images sur &amp;fond clair</translation></message>
    <message><source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation></message>
    <message><source>Pictures (*.{0})</source>
        <translation>Images (*.{0})</translation></message>
    <message numerus="yes"><source>{0} sample(s) written to {1}.</source>
        <translation><numerusform>{0} échantillon écrit dans {1}.</numerusform><numerusform>{0} échantillons écrits dans {1}.</numerusform></translation></message>
    <message><source>E&amp;xport</source>
        <translation>&amp;Exporter</translation></message>
    <message><source>Pictu&amp;re</source>
        <translation>&amp;Image</translation></message>
    <message><source>Save what the plot shows as PNG or SVG</source>
        <translation>Enregistrer ce que montre le graphique en PNG ou SVG</translation></message>
    <message><source>&amp;Visible range as CSV…</source>
        <translation>Plage &amp;visible en CSV…</translation></message>
    <message><source>&amp;Everything as CSV…</source>
        <translation>&amp;Tout en CSV…</translation></message>
    <message><source>There is nothing to export yet.</source>
        <translation>Il n'y a encore rien à exporter.</translation></message>
    <message><source>The picture was written to {0}.</source>
        <translation>L'image a été écrite dans {0}.</translation></message>
    <message><source>Limit</source>
        <translation>Limite</translation></message>
    <message><source>In the visible span</source>
        <translation>Sur la plage visible</translation></message>
    <message><source>Select an event to show it in the plot.</source>
        <translation>En choisir un montre sa place dans le graphique.</translation></message>
    <message><source>Curves and their figures</source>
        <translation>Courbes et leurs valeurs</translation></message>
    <message><source>No events yet. Stops, applied settings, faults and exceeded limits will be listed here.</source>
        <translation>Aucun événement pour l'instant. Les arrêts, les réglages appliqués, les défauts et les limites apparaîtront ici.</translation></message>
    <message><source>Select the curves to draw</source>
        <translation>Sélectionner les courbes à tracer</translation></message>
    <message><source>Now</source>
        <translation>Maintenant</translation></message>
    <message><source>Newest value; ⚠ means 80 % of the limit or more</source>
        <translation>Valeur la plus récente ; ⚠ signifie 80 % de la limite ou plus</translation></message>
    <message><source>Root mean square in the visible span; determines the heat in wires</source>
        <translation>Valeur efficace sur la plage visible : c'est elle qui chauffe les fils</translation></message>
    <message><source>Current times time in the visible span, without gaps</source>
        <translation>Courant multiplié par le temps sur la plage visible, sans les trous</translation></message>
    <message><source>Cursor</source>
        <translation>Curseur</translation></message>
    <message><source>To mark</source>
        <translation>Δ repère</translation></message>
    <message><source>Difference between the mark and the cursor; click the plot or press M to set the mark</source>
        <translation>Du repère au curseur ; cliquez dans le graphique ou appuyez sur M pour le placer</translation></message>
    <message><source>Held</source>
        <translation>Tenue</translation></message>
    <message><source>Highest value since Hold peaks was switched on</source>
        <translation>Valeur la plus élevée depuis l'activation de « Tenir les crêtes »</translation></message>
    <message><source>{0}, {1}: {2}, near its limit</source>
        <translation>{0}, {1} : {2}, près de sa limite</translation></message>
    <message><source>{0}, {1}: {2}, over its limit</source>
        <translation>{0}, {1} : {2}, au-dessus de sa limite</translation></message>
    <message><source>No events</source>
        <translation>Aucun événement</translation></message>
    <message><source>Apply</source>
        <translation>Appliqué</translation></message>
    <message><source>Timeout</source>
        <translation>Délai dépassé</translation></message>
    <message><source>Line</source>
        <translation>Liaison</translation></message>
    <message><source>Events in the plot</source>
        <translation>Événements du graphique</translation></message>
    <message><source>Names of the curves</source>
        <translation>Noms des courbes</translation></message>
    <message><source>{0} ({1} from the mark)</source>
        <translation>{0} ({1} depuis le repère)</translation></message>
    <message><source>Blue</source>
        <translation>Bleu</translation></message>
    <message><source>Orange</source>
        <translation>Orange</translation></message>
    <message><source>Yellow</source>
        <translation>Jaune</translation></message>
    <message><source>Purple</source>
        <translation>Violet</translation></message>
    <message><source>Teal</source>
        <translation>Turquoise</translation></message>
    <message><source>Pink</source>
        <translation>Rose</translation></message>
    <message><source>Grey</source>
        <translation>Gris</translation></message>
    <message><source>Text colour</source>
        <translation>Comme le texte</translation></message>
    <message><source>A fixed range keeps plots comparable; peaks above it are cut off</source>
        <translation>Une plage fixe permet de comparer les graphiques ; les crêtes au-dessus sont tronquées</translation></message>
    <message><source>Range of the currents</source>
        <translation>Plage des courants</translation></message>
    <message><source>La&amp;yout</source>
        <translation>Disp&amp;osition</translation></message>
    <message><source>&amp;Reset layout</source>
        <translation>&amp;Réinitialiser la disposition</translation></message>
    <message><source>Time shown</source>
        <translation>Durée affichée</translation></message>
    <message><source>Pa&amp;use</source>
        <translation>Pa&amp;use</translation></message>
    <message><source>Hold pea&amp;ks</source>
        <translation>Tenir les &amp;crêtes</translation></message>
    <message><source>&amp;Colours</source>
        <translation>&amp;Couleurs</translation></message>
    <message><source>Show the &amp;last</source>
        <translation>Afficher le&amp;s dernières</translation></message>
    <message><source>automatic</source>
        <translation>automatique</translation></message>
    <message><source>Ran&amp;ge</source>
        <translation>Pla&amp;ge</translation></message>
    <message><source>From now on, show the highest value of each curve as a line and in the table</source>
        <translation>Garder à partir de maintenant la valeur la plus élevée de chaque courbe, sous forme de trait et de valeur</translation></message>
    <message><source>Back to li&amp;ve</source>
        <translation>Re&amp;venir au direct</translation></message>
    <message><source>Left and Right move the cursor, with Shift in large steps. The values at the cursor are read out here. M sets a mark, Plus and Minus zoom, and L returns to the live view.</source>
        <translation>Gauche et Droite déplacent le curseur, par grands pas avec Maj ; ses valeurs sont annoncées ici. M place un repère, plus et moins zooment, L revient au direct.</translation></message>
    <message><source>Plot of currents and speeds against time</source>
        <translation>Graphique des courants et des vitesses en fonction du temps</translation></message>
    <message><source>No data yet</source>
        <translation>Pas encore de données</translation></message>
    <message><source>Also show the requests that the program repeats many times a second</source>
        <translation>Afficher aussi les requêtes que le programme répète de nombreuses fois par seconde</translation></message>
    <message><source>Remove all rows</source>
        <translation>Supprimer toutes les lignes</translation></message>
    <message><source>No row matches the search.</source>
        <translation>Aucune ligne ne correspond à la recherche.</translation></message>
    <message><source>No faults so far.</source>
        <translation>Aucun défaut jusqu'ici.</translation></message>
    <message><source>Save the traffic log</source>
        <translation>Enregistrer le journal de trafic</translation></message>
    <message><source>Text (*.txt *.tsv)</source>
        <translation>Texte (*.txt *.tsv)</translation></message>
    <message numerus="yes"><source>{0} row(s) written to {1}.</source>
        <translation><numerusform>{0} ligne écrite dans {1}.</numerusform><numerusform>{0} lignes écrites dans {1}.</numerusform></translation></message>
    <message><source>&amp;Copy</source>
        <translation>&amp;Copier</translation></message>
    <message><source>Copy as &amp;Python</source>
        <translation>Copier en &amp;Python</translation></message>
    <message><source>Copy as &amp;Arduino sketch</source>
        <translation>Copier en sketch &amp;Arduino</translation></message>
    <message><source>Sa&amp;ve as text…</source>
        <translation>Enregistrer en te&amp;xte…</translation></message>
    <message numerus="yes"><source>%n fault(s)</source>
        <translation><numerusform>%n défaut</numerusform><numerusform>%n défauts</numerusform></translation></message>
    <message><source>no faults</source>
        <translation>aucun défaut</translation></message>
    <message><source>polling hidden</source>
        <translation>interrogation masquée</translation></message>
    <message><source>paused</source>
        <translation>en pause</translation></message>
    <message><source>No traffic yet. While {0} is connected, this page lists every byte on the line and its meaning.</source>
        <translation>Pas encore de trafic. Pendant la connexion avec {0}, cette page liste chaque octet sur la liaison et sa signification.</translation></message>
    <message><source>No rows to save.</source>
        <translation>Aucune ligne à enregistrer.</translation></message>
    <message><source>&amp;Show polling</source>
        <translation>Afficher l'inte&amp;rrogation</translation></message>
    <message><source>O&amp;nly faults</source>
        <translation>Défauts &amp;seulement</translation></message>
    <message><source>Show only failed transactions and line errors</source>
        <translation>N'afficher que les transactions échouées et les erreurs de liaison</translation></message>
    <message><source>Stop adding rows; the traffic is still logged</source>
        <translation>Ne pas ajouter de lignes pour l'instant ; le trafic reste journalisé</translation></message>
    <message><source>events lost: {0}</source>
        <translation>événements perdus : {0}</translation></message>
    <message><source>Send &amp;bytes</source>
        <translation>En&amp;voyer les octets</translation></message>
    <message><source>Send these bytes unchanged (Enter)</source>
        <translation>Envoyer ces octets tels quels (Entrée)</translation></message>
    <message><source>Bytes t&amp;o send:</source>
        <translation>&amp;Octets à envoyer :</translation></message>
    <message><source>Sent</source>
        <translation>Envoyé</translation></message>
    <message><source>Received</source>
        <translation>Reçu</translation></message>
    <message><source>Took (ms)</source>
        <translation>Durée (ms)</translation></message>
    <message><source>Meaning</source>
        <translation>Signification</translation></message>
    <message><source>Traffic on the line</source>
        <translation>Trafic sur la liaison</translation></message>
    <message><source>Details of the selected row</source>
        <translation>Détails de la ligne sélectionnée</translation></message>
    <message><source>Select a row to see all its bytes.</source>
        <translation>Sélectionnez une ligne pour voir tous ses octets.</translation></message>
    <message numerus="yes"><source>took      {0:.1f} ms; %n byte(s) take {1:.1f} ms at this baud rate</source>
        <translation><numerusform>durée     {0:.1f} ms ; %n octet demande {1:.1f} ms à ce débit</numerusform><numerusform>durée     {0:.1f} ms ; %n octets demandent {1:.1f} ms à ce débit</numerusform></translation></message>
    <message><source>Fault: {0}</source>
        <translation>Défaut : {0}</translation></message>
    <message><source>sent      {0}</source>
        <translation>envoyé    {0}</translation></message>
    <message><source>received  {0}</source>
        <translation>reçu      {0}</translation></message>
    <message><source>Columns</source>
        <translation>Colonnes</translation></message>
    <message><source>Rows</source>
        <translation>Lignes</translation></message>
    <message><source>{0} is still being saved. Close without waiting? Changes may be lost.</source>
        <translation>{0} est encore en cours d'enregistrement. Fermer sans attendre ? Des modifications peuvent être perdues.</translation></message>
    <message><source>Text files (*.txt);;All files (*)</source>
        <translation>Fichiers texte (*.txt);;Tous les fichiers (*)</translation></message>
    <message><source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation></message>
    <message><source>Changed on disk</source>
        <translation>Modifié sur le disque</translation></message>
    <message><source>Still saving</source>
        <translation>Enregistrement en cours</translation></message>
    <message><source>Rewrite the file</source>
        <translation>Réécrire le fichier</translation></message>
    <message><source>Replace the file</source>
        <translation>Remplacer le fichier</translation></message>
    <message><source>{0} was changed by another program since it was opened here. Overwrite those changes?</source>
        <translation>{0} a été modifié par un autre programme depuis son ouverture ici. Écraser ces modifications ?</translation></message>
    <message><source>The changes cannot be merged into the text of the file: {0}.

Rewrite the file from the settings? Its comments will be lost.</source>
        <translation>Les modifications ne peuvent pas être intégrées au texte du fichier : {0}.

Réécrire le fichier à partir des réglages ? Ses commentaires seront perdus.</translation></message>
    <message><source>{0} {1} Replace it?</source>
        <translation>{0} {1} Le remplacer ?</translation></message>
    <message><source>{0} has changes that are not saved. Save them?</source>
        <translation>{0} contient des modifications non enregistrées. Les enregistrer ?</translation></message>
    <message><source>already exists.</source>
        <translation>existe déjà.</translation></message>
    <message><source>Error</source>
        <translation>Erreur</translation></message>
    <message><source>Information</source>
        <translation>Information</translation></message>
    <message><source>OK</source>
        <translation>OK</translation></message>
    <message><source>Not done</source>
        <translation>Non fait</translation></message>
    <message><source>Warning</source>
        <translation>Avertissement</translation></message>
    <message><source>Reconnect</source>
        <translation>Reconnecter</translation></message>
    <message><source>Stop them now</source>
        <translation>Les arrêter maintenant</translation></message>
    <message><source>Connect with its settings</source>
        <translation>Connecter avec ses réglages</translation></message>
    <message><source>Dismiss</source>
        <translation>Fermer</translation></message>
    <message><source>Copied</source>
        <translation>Copié</translation></message>
    <message><source>No message</source>
        <translation>Aucun message</translation></message>
    <message><source>All steps are done.</source>
        <translation>Toutes les étapes sont faites.</translation></message>
    <message><source>Step {0} of {1}: {2}.</source>
        <translation>Étape {0} sur {1} : {2}.</translation></message>
    <message><source>Not done: {0}.</source>
        <translation>Non fait : {0}.</translation></message>
    <message numerus="yes"><source>%n line(s) copied.</source>
        <translation><numerusform>%n ligne copiée.</numerusform><numerusform>%n lignes copiées.</numerusform></translation></message>
    <message><source>Internal error while processing this file ({0}).</source>
        <translation>Erreur interne lors du traitement de ce fichier ({0}).</translation></message>
    <message><source>Internal error while recording ({0}). The recording has ended.</source>
        <translation>Erreur interne pendant l'enregistrement ({0}). L'enregistrement est terminé.</translation></message>
    <message><source>Internal error: the connection was closed.</source>
        <translation>Erreur interne : la connexion a été fermée.</translation></message>
    <message><source>Device Number</source>
        <translation>Numéro d'appareil</translation></message>
    <message><source>The number that addresses this board in packets of the Pololu protocol. The board accepts compact packets whatever its number. Several boards on one line need different numbers.</source>
        <translation>Le numéro qui désigne cette carte dans les paquets du protocole Pololu. La carte accepte les paquets compacts quel que soit son numéro. Plusieurs cartes sur une même liaison ont besoin de numéros différents.</translation></message>
    <message><source>Required Channels</source>
        <translation>Voies requises</translation></message>
    <message><source>In RC mode, losing the signal of a required channel for more than 0.5 s puts the board into safe-start: the motors stop until the signal is back and the sticks are at neutral.</source>
        <translation>En mode RC, la perte du signal d'une voie requise pendant plus de 0,5 s met la carte en démarrage sécurisé : les moteurs s'arrêtent jusqu'à ce que le signal revienne et que les manches soient au neutre.</translation></message>
    <message><source>Ignored Channels</source>
        <translation>Voies ignorées</translation></message>
    <message><source>An ignored channel is held at its neutral value, whatever is connected. Select the inputs that are not connected.</source>
        <translation>Une voie ignorée est maintenue à sa valeur de neutre, quoi qu'on y connecte. Sélectionnez les entrées qui ne sont pas connectées.</translation></message>
    <message><source>Reversed Channels</source>
        <translation>Voies inversées</translation></message>
    <message><source>Swaps forward and reverse of the selected channels.</source>
        <translation>Échange marche avant et marche arrière des voies sélectionnées.</translation></message>
    <message><source>Parabolic Channels</source>
        <translation>Voies paraboliques</translation></message>
    <message><source>A parabolic channel responds gently near neutral and strongly near the ends (a parabola instead of a straight line).</source>
        <translation>Une voie parabolique réagit doucement près du neutre et fortement près des extrémités (une parabole au lieu d'une droite).</translation></message>
    <message><source>Motor 1 Deadband Brake PWM</source>
        <translation>PWM de freinage en zone morte moteur 1</translation></message>
    <message><source>How hard the motor is braked while its channel is within the deadband: 100 % is a full brake, 0 lets the motor coast (inferred).</source>
        <translation>Intensité du freinage du moteur quand sa voie est dans la zone morte : 100 % est un freinage à fond, 0 laisse le moteur en roue libre (déduit).</translation></message>
    <message><source>Deadband Brake PWM</source>
        <translation>PWM de freinage en zone morte</translation></message>
    <message><source>Motor 2 Deadband Brake PWM</source>
        <translation>PWM de freinage en zone morte moteur 2</translation></message>
    <message><source>Serial Timeout</source>
        <translation>Délai série</translation></message>
    <message><source>The motors should stop when the board receives no byte for this long. It protects you when the computer or the cable fails. 0 switches it off. It may need UART-Error Shutdown (twin): leave that on.</source>
        <translation>Les moteurs devraient s'arrêter quand la carte ne reçoit aucun octet pendant ce temps. Cela vous protège si l'ordinateur ou le câble tombe en panne. 0 le désactive. Il peut avoir besoin de « Arrêt sur erreur UART » (jumeau) : laissez celui-ci activé.</translation></message>
    <message><source>UART-Error Shutdown</source>
        <translation>Arrêt sur erreur UART</translation></message>
    <message><source>Whether a serial error (noise, wrong baud rate, malformed packet) stops the motors. The board still accepts commands. The next motor command starts them again (inferred). Switched off, it may disable the Serial Timeout, too (twin).</source>
        <translation>Détermine si une erreur série (bruit, mauvais débit, paquet mal formé) arrête les moteurs. La carte accepte toujours les commandes. La commande de moteur suivante les remet en marche (déduit). Désactivé, ce réglage peut rendre aussi le « Délai série » inopérant (jumeau).</translation></message>
    <message><source>The default of on is doubtful: public programs that send a stray byte with each command, or pause within a packet, would stutter with it.</source>
        <translation>La valeur par défaut « activé » est douteuse : des programmes publics qui envoient un octet parasite avec chaque commande, ou marquent une pause dans un paquet, auraient des à-coups.</translation></message>
    <message><source>Motor 1 PWM Prescaler</source>
        <translation>Prédiviseur PWM moteur 1</translation></message>
    <message><source>Divides the clock of the motor's PWM. Together with PWM Maximum it sets the PWM frequency: lower frequencies whine and heat the motor, frequencies above the driver's rating heat the driver.</source>
        <translation>Divise l'horloge du PWM du moteur. Avec « Maximum PWM », il fixe la fréquence PWM : une fréquence basse fait siffler et chauffer le moteur, une fréquence supérieure à celle prévue pour le driver fait chauffer le driver.</translation></message>
    <message><source>PWM Prescaler</source>
        <translation>Prédiviseur PWM</translation></message>
    <message><source>clock / 8</source>
        <translation>horloge / 8</translation></message>
    <message><source>clock / 64</source>
        <translation>horloge / 64</translation></message>
    <message><source>clock / 256</source>
        <translation>horloge / 256</translation></message>
    <message><source>clock / 1024</source>
        <translation>horloge / 1024</translation></message>
    <message><source>Motor 2 PWM Prescaler</source>
        <translation>Prédiviseur PWM moteur 2</translation></message>
    <message><source>Motor 1 PWM Maximum</source>
        <translation>Maximum PWM moteur 1</translation></message>
    <message><source>The value at which the PWM counter starts again. Together with the prescaler it sets the PWM frequency: a smaller maximum gives a higher frequency.</source>
        <translation>La valeur à laquelle le compteur PWM recommence. Avec le prédiviseur, elle fixe la fréquence PWM : un maximum plus petit donne une fréquence plus élevée.</translation></message>
    <message><source>PWM Maximum</source>
        <translation>Maximum PWM</translation></message>
    <message><source>Motor 2 PWM Maximum</source>
        <translation>Maximum PWM moteur 2</translation></message>
    <message><source>Auxiliary Motor PWM Maximum</source>
        <translation>Maximum PWM moteur auxiliaire</translation></message>
    <message><source>The value at which the PWM counter starts again: a smaller maximum gives a higher PWM frequency. No parameter sets the prescaler of this motor.</source>
        <translation>La valeur à laquelle le compteur PWM recommence : un maximum plus petit donne une fréquence PWM plus élevée. Aucun paramètre ne règle le prédiviseur de ce moteur.</translation></message>
    <message><source>Motor 1 Acceleration</source>
        <translation>Accélération moteur 1</translation></message>
    <message><source>How fast the speed may grow after an accelerate command, in speed steps (of 127) per 100 ms. 0 means at once. Slowing down in the same direction has no ramp.</source>
        <translation>Rapidité à laquelle la vitesse peut augmenter après une commande d'accélération, en pas de vitesse (sur 127) par 100 ms. 0 signifie d'un coup. Ralentir dans le même sens se fait sans rampe.</translation></message>
    <message><source>no ramp</source>
        <translation>pas de rampe</translation></message>
    <message><source>Acceleration</source>
        <translation>Accélération</translation></message>
    <message><source>Motor 2 Acceleration</source>
        <translation>Accélération moteur 2</translation></message>
    <message><source>Auxiliary Motor Acceleration</source>
        <translation>Accélération moteur auxiliaire</translation></message>
    <message><source>How fast the auxiliary motor may speed up after an accelerate command, in speed steps (of 127) per 100 ms. 0 means at once.</source>
        <translation>Rapidité à laquelle le moteur auxiliaire peut accélérer après une commande d'accélération, en pas de vitesse (sur 127) par 100 ms. 0 signifie d'un coup.</translation></message>
    <message><source>Motor 1 Brake Duration</source>
        <translation>Durée de freinage moteur 1</translation></message>
    <message><source>How long the motor is fully braked before an accelerate command reverses it.</source>
        <translation>Durée du freinage à fond du moteur avant qu'une commande d'accélération n'inverse son sens.</translation></message>
    <message><source>no braking</source>
        <translation>pas de freinage</translation></message>
    <message><source>Brake Duration</source>
        <translation>Durée de freinage</translation></message>
    <message><source>Motor 2 Brake Duration</source>
        <translation>Durée de freinage moteur 2</translation></message>
    <message><source>Motor 1 Current Limit</source>
        <translation>Limite de courant moteur 1</translation></message>
    <message><source>Above this current the board lowers the motor's speed and latches an over-limit bit. Use accelerate commands with it: set commands bypass it for a moment. 0 switches it off (twin). Measured currents may be off by 20 % (twin). It has no effect in joint mode.</source>
        <translation>Au-dessus de ce courant, la carte réduit la vitesse du moteur et mémorise un bit de dépassement. Utilisez avec elle les commandes d'accélération : les commandes immédiates la contournent un instant. 0 la désactive (jumeau). La carte peut se tromper de 20 % en mesurant les courants (jumeau). Sans effet en mode jumelé.</translation></message>
    <message><source>Current Limit</source>
        <translation>Limite de courant</translation></message>
    <message><source>Motor 2 Current Limit</source>
        <translation>Limite de courant moteur 2</translation></message>
    <message><source>Motor 1 Current Limit Proportionality Constant P</source>
        <translation>Constante de proportionnalité P de la limite de courant moteur 1</translation></message>
    <message><source>How strongly the limiter responds to each count above the limit. A large value reacts fast but may make the motor pulse (inferred).</source>
        <translation>Force de la réaction du limiteur à chaque count au-dessus de la limite. Une grande valeur réagit vite, mais peut faire tourner le moteur par à-coups (déduit).</translation></message>
    <message><source>Current Limit Proportionality Constant P</source>
        <translation>Constante de proportionnalité P de la limite de courant</translation></message>
    <message><source>Motor 2 Current Limit Proportionality Constant P</source>
        <translation>Constante de proportionnalité P de la limite de courant moteur 2</translation></message>
    <message><source>Enable UART Response Delay</source>
        <translation>Activer le délai de réponse UART</translation></message>
    <message><source>Makes the board wait 1 ms before it replies, for computers that switch slowly from sending to receiving.</source>
        <translation>Fait attendre la carte 1 ms avant de répondre, pour les ordinateurs lents à passer de l'émission à la réception.</translation></message>
    <message><source>1 ms</source>
        <translation>1 ms</translation></message>
    <message><source>Motor Mode</source>
        <translation>Mode moteur</translation></message>
    <message><source>Independent: two motors. Joint: both drivers together drive one stronger motor as motor 1, without current sensing and mixing.</source>
        <translation>Indépendants : deux moteurs. Jumelés : les deux drivers entraînent ensemble un seul moteur plus puissant, comme moteur 1, sans mesure de courant ni mixage.</translation></message>
    <message><source>independent</source>
        <translation>indépendants</translation></message>
    <message><source>joint</source>
        <translation>jumelés</translation></message>
    <message><source>Channel Input Source</source>
        <translation>Source des entrées des voies</translation></message>
    <message><source>Whether the five inputs are read as RC pulses or as voltages while the board is in serial mode. In RC and analog mode the jumper decides.</source>
        <translation>Détermine si les cinq entrées sont lues comme impulsions RC ou comme tensions quand la carte est en mode série. En modes RC et analogique, c'est le cavalier qui décide.</translation></message>
    <message><source>CRC-7 Polynomial</source>
        <translation>Polynôme CRC-7</translation></message>
    <message><source>The polynomial of the checksum after every packet, used when CRC-7 is chosen in the UART settings. Its top bit is always 1.</source>
        <translation>Le polynôme de la somme de contrôle après chaque paquet, utilisé quand CRC-7 est choisi dans « Réglages UART ». Son bit de poids fort vaut toujours 1.</translation></message>
    <message><source>UART Settings</source>
        <translation>Réglages UART</translation></message>
    <message><source>Baud rate, error detection (none, CRC-7 or parity) and stop bits of the serial line. A wrong setting makes the board unreachable until the program's settings match.</source>
        <translation>Débit (bauds), détection d'erreurs (aucune, CRC-7 ou parité) et bits d'arrêt de la liaison série. Un mauvais réglage rend la carte injoignable tant que les réglages du programme ne correspondent pas.</translation></message>
    <message><source>Reset All Parameters to Factory Defaults</source>
        <translation>Réinitialiser tous les paramètres aux réglages d'usine</translation></message>
    <message><source>Resets every parameter to its factory default at the next power cycle.</source>
        <translation>Réinitialise tous les paramètres à leur réglage d'usine à la prochaine mise sous tension.</translation></message>
</context>
</TS>
