/** German texts of the page. The compiler reports texts that are missing or have other arguments. */

import type { Translation } from "./translate";

export const de = {
  // api/columns.ts
  "columns.theServerSentDataOf":
    "Der Server hat Daten in unbekanntem Format gesendet („{magic}“ statt „{magic2}“). Die Seite neu laden.",
  "columns.theDataFromTheServer":
    "Die Daten des Servers sind unvollständig: Ihr Kopf sollte {size, number} Byte haben. Die Seite neu laden.",
  "columns.theDataFromTheServer2":
    "Die Daten des Servers sind unvollständig: Spalte {name} sollte {count, number} Werte haben ({dtype}). Die Seite neu laden.",
  "columns.theDataFromTheServer3":
    "In den Daten des Servers fehlt die Spalte {name}. Die Seite neu laden.",
  // api/errors.ts
  "errors.noResponseFromTheServer": "Keine Antwort vom Server",
  "errors.theKnifetipServerDoesNot": "Der knifetip-Server antwortet nicht.",
  "errors.checkThatTheServerIs":
    "Prüfen, ob der Server läuft und dieser Rechner ihn erreicht. Dann noch einmal versuchen.",
  "errors.error": "Fehler {status}",
  "errors.theKnifetipServerAnsweredWith":
    "Der knifetip-Server hat mit Fehler {status} geantwortet ({title}).",
  "errors.theKnifetipServerAnsweredWith2":
    "Der knifetip-Server hat mit Fehler {status} geantwortet.",
  "errors.tryAgainIfTheError":
    "Noch einmal versuchen. Bleibt der Fehler, die Ursache im Protokoll des Servers suchen.",
  // app/App.tsx
  "app.thereIsNoSuchPage": "Diese Seite gibt es nicht",
  // app/DrawingError.tsx
  "drawingError.thisDrawingCannotBeOpened": "Diese Zeichnung kann nicht geöffnet werden",
  // app/DropZone.tsx
  "dropZone.dropDrawingFilesHereTo": "Zeichnungen hier ablegen, um sie zu öffnen",
  // app/LibraryPage.tsx
  "libraryPage.importedFrom": "importiert aus {name}",
  "libraryPage.machinesBoardsAndTools": "Maschinen, Material und Werkzeuge",
  "libraryPage.thereIsNo":
    "Es gibt {shelf, select, machines {keine Maschine} boards {kein Material} other {kein Werkzeug}} namens {name}",
  "libraryPage.all": "Alle",
  "libraryPage.supplied": "mitgeliefert",
  "libraryPage.own": "eigene",
  "libraryPage.v": "v{version}",
  "libraryPage.importFromATomlFile":
    "{shelf, select, machines {Maschine} boards {Material} other {Werkzeug}} aus TOML-Datei importieren",
  "libraryPage.chooseAMachineABoard":
    "Eine Maschine, ein Material oder ein Werkzeug wählen. Für eigene einen mitgelieferten Eintrag kopieren, der Kopie einen Namen geben und ihre Werte ändern.",
  // app/Part.tsx
  "part.loading": "Wird geladen",
  "part.thisPartOfThePage": "Dieser Teil der Seite kann nicht geladen werden",
  "part.theServerDoesNotRespond":
    "Der Server antwortet nicht, oder er wurde aktualisiert, seit die Seite geöffnet wurde.",
  "part.reloadThePage": "Seite neu laden",
  // app/Picture.tsx
  "picture.theDielineAndThePath":
    "Die Stanzkontur und die Bahn des Maschinenkopfs. Pfeiltasten verschieben die Ansicht, Plus und Minus vergrößern und verkleinern, die Taste F zeigt die ganze Zeichnung.",
  // app/StationPage.tsx
  "stationPage.theSheetOnTheTable":
    "Der Bogen auf dem Tisch, die Bahn des Kopfs und der Kopf, während ein Auftrag läuft.",
  "stationPage.backToAllDrawings": "Zurück zu allen Zeichnungen",
  "stationPage.loadingTheMachine": "Maschine wird geladen",
  "stationPage.thereIsNoMachineNamed":
    "Es gibt keine Maschine namens {name}. Die Zeichnungen öffnen und dort eine Maschine wählen.",
  "stationPage.noConnectionToTheServer":
    "<b>Keine Verbindung zum Server.</b> Diese Seite kann veraltet sein, und ihre Tasten haben keine Wirkung. Bei Gefahr den Not-Halt der Maschine benutzen.",
  "stationPage.noJobWaitsForThis": "Kein Auftrag wartet auf diese Maschine.",
  "stationPage.jobOrMachine": "Auftrag oder Maschine",
  "stationPage.job": "Auftrag",
  "stationPage.moveMachine": "Maschine bewegen",
  "stationPage.theQueueOfThisMachine":
    "Die Warteschlange dieser Maschine ist leer. Ein Auftrag erscheint hier, sobald er an die Maschine gesendet wird.",
  // app/StatusBar.tsx
  "statusBar.fileUnits": "Dateieinheiten",
  "statusBar.xY": "X {x}  Y {y} {unit}",
  // app/TopBar.tsx
  "topBar.undoTheLastChangeCtrl": "Letzte Änderung rückgängig machen (Strg Z)",
  "topBar.redoTheUndoneChangeCtrl": "Rückgängig gemachte Änderung wiederholen (Strg Umschalt Z)",
  "topBar.keyboardAndMouseShortcuts": "Tastatur- und Mausbefehle (?)",
  // app/WebGlError.tsx
  "webGlError.theDrawingCannotBeDisplayed": "Die Zeichnung kann nicht angezeigt werden",
  "webGlError.toSeeTheDrawingTurn":
    "{why} Um die Zeichnung zu sehen, in den Einstellungen des Browsers die Hardwarebeschleunigung einschalten oder ein aktuelles Firefox, Chrome, Edge oder Safari verwenden. Der Rest dieser Seite funktioniert auch so.",
  "webGlError.reloadThePage": "Seite neu laden",
  // panels/cartons
  "cartonPage.cartonsFromAStandard": "Schachtel nach Standard",
  "cartonPage.cartons": "Schachteln",
  "cartonPage.chooseAStyle":
    "Eine Form wählen, dann die Innenmaße eingeben. Die Dicke des Materials bestimmt die Zugaben.",
  "cartonPage.allStyles": "Alle Formen",
  "cartonPage.innerDimensions": "Innenmaße",
  "cartonPage.options": "Optionen",
  "cartonPage.makeDrawing": "Zeichnung erstellen",
  "cartonPage.unusualBoard": "{board} (für diese Form unüblich)",
  "cartonPage.pictureOf": "Zeichnung: {name}",
  "cartonPage.noSuchStyle": "Die Form {code} gibt es nicht.",
  // app/WebhooksPage.tsx
  "webhooksPage.webhooks": "Webhooks",
  "webhooksPage.addAWebhook": "Webhook hinzufügen",
  "webhooksPage.changesOfJobsAndDrawings":
    "Änderungen von Aufträgen und Zeichnungen werden als signierte Anfragen (Standard Webhooks) an diese URLs gesendet. Noch gibt es keine Webhooks.",
  "webhooksPage.changesOfJobsAndDrawings2":
    "Änderungen von Aufträgen und Zeichnungen werden als signierte Anfragen (Standard Webhooks) an diese URLs gesendet.",
  "webhooksPage.newWebhook": "Neuer Webhook",
  "webhooksPage.add": "Hinzufügen",
  // app/Welcome.tsx
  "welcome.dropADielineFileHere": "Stanzzeichnung hier ablegen",
  "welcome.dxfSvgCf2PdfHpgl":
    "DXF, SVG, CF2, PDF, HPGL oder LightBurn. knifetip erkennt Schnitte, Rillen und Nuten, berechnet die Werkzeugbahnen für die Maschine und prüft das Programm, bevor sich die Maschine bewegt.",
  // app/ZoomControls.tsx
  "zoomControls.zoomInKey": "Vergrößern (Taste +)",
  "zoomControls.zoomOutKey": "Verkleinern (Taste −)",
  "zoomControls.showTheWholeDrawingKey": "Ganze Zeichnung zeigen (Taste F)",
  // app/theme.ts
  "theme.close": "Schließen",
  // panels/accounts/AccountDialog.tsx
  "accountDialog.youCanViewDrawingsJobs":
    "Sie können Zeichnungen, Aufträge und Maschinen ansehen, aber nicht ändern.",
  "accountDialog.youCanUploadAndChange":
    "Sie können Zeichnungen hochladen und ändern und Aufträge anlegen. Ein Bediener muss die Aufträge freigeben.",
  "accountDialog.youCanOrderReleaseAnd":
    "Sie können Aufträge anlegen, freigeben und steuern und Maschinen bedienen.",
  "accountDialog.youCanDoEverythingAnd":
    "Sie können alles tun und Bibliothek, Benutzer und Schlüssel verwalten.",
  "accountDialog.accountSignInIsNot": "Konto: Anmeldung noch nicht eingerichtet",
  "accountDialog.account": "Konto: {name}",
  "accountDialog.account2": "Konto",
  "accountDialog.myAccount": "Mein Konto",
  "accountDialog.users": "Benutzer",
  "accountDialog.apiKeys": "API-Schlüssel",
  "accountDialog.auditLog": "Prüfprotokoll",
  "accountDialog.signedInAs": "Angemeldet als <strong>{name}</strong> ({role}).",
  "accountDialog.signOut": "Abmelden",
  "accountDialog.yourPasswordAndYourRole":
    "Passwort und Rolle verwaltet der Anbieter, über den Sie sich anmelden.",
  "accountDialog.thisDeviceIsPairedWith":
    "Dieses Gerät, <strong>{name}</strong>, ist mit {machines} gekoppelt. Es darf diese Maschine starten, fortsetzen und bewegen und sieht ihre Aufträge.",
  "accountDialog.unpairThisDevice": "Dieses Gerät entkoppeln",
  "accountDialog.noAdministratorExistsYetEvery":
    "Noch gibt es keinen Administrator. Jedes Programm auf diesem Rechner hat vollen Zugriff, andere Rechner haben keinen. Den ersten Administrator hier anlegen oder mit diesem Befehl:",
  "accountDialog.createTheAdministrator": "Administrator anlegen",
  "accountDialog.name": "Name",
  "accountDialog.password": "Passwort",
  "accountDialog.atLeastTenCharacters": "Mindestens zehn Zeichen",
  "accountDialog.passwordChangedYourOtherSessions":
    "Passwort geändert. Ihre anderen Sitzungen wurden abgemeldet.",
  "accountDialog.changeThePassword": "Passwort ändern",
  "accountDialog.currentPassword": "Bisheriges Passwort",
  "accountDialog.newPassword": "Neues Passwort",
  "accountDialog.userCreated": "Benutzer {name} angelegt.",
  "accountDialog.createAUser": "Benutzer anlegen",
  "accountDialog.role": "Rolle",
  "accountDialog.neverSignedIn": "nie angemeldet",
  "accountDialog.disabled": "gesperrt",
  "accountDialog.roleOf": "Rolle von {name}",
  "accountDialog.disable": "Sperren",
  "accountDialog.enable": "Entsperren",
  "accountDialog.copyTheKeyNowIt":
    "Den Schlüssel jetzt kopieren. Er kann nicht noch einmal gezeigt werden.",
  "accountDialog.neverUsed": "nie benutzt",
  "accountDialog.used": "benutzt {used}",
  "accountDialog.customer": "Kunde {customer}",
  "accountDialog.anyMachine": "jede Maschine",
  "accountDialog.expires": "läuft ab {expires}",
  "accountDialog.revoke": "Sperren",
  "accountDialog.revoked": "gesperrt",
  "accountDialog.createAKey": "Schlüssel anlegen",
  "accountDialog.usedBy": "Titel des Schlüssels",
  "accountDialog.programThatUsesTheKey": "Programm, das den Schlüssel benutzt",
  "accountDialog.scopes": "Berechtigungen",
  "accountDialog.noRoleLetsAKey":
    "Um eine Maschine zu starten oder zu bewegen, braucht ein Schlüssel die Berechtigung station: keine andere enthält sie",
  "accountDialog.customerOptional": "Kunde (optional)",
  "accountDialog.theKeySeesAndOrders":
    "Der Schlüssel sieht und bestellt nur Aufträge dieses Kunden",
  "accountDialog.machinesOptional": "Maschinen (optional)",
  "accountDialog.theKeyIsForThese": "Der Schlüssel gilt nur für diese Maschinen",
  "accountDialog.expiresOptional": "Läuft ab (optional)",
  "accountDialog.unknown": "unbekannt",
  // panels/accounts/OperatorForm.tsx
  "operatorForm.nameOfTheOperator": "Name des Bedieners",
  "operatorForm.yourName": "Ihr Name",
  "operatorForm.whoWorksAtThisDevice": "Wer arbeitet an diesem Gerät?",
  "operatorForm.save": "Speichern",
  "operatorForm.noName": "Kein Name",
  "operatorForm.cancel": "Abbrechen",
  "operatorForm.recordedWithWhatYouConfirm":
    "Der Name wird mit Bestätigungen und Änderungen gespeichert und auf diesem Gerät gemerkt.",
  "operatorForm.operator": "Bediener",
  "operatorForm.changeTheNameOfThe": "Namen des Bedieners ändern",
  // panels/accounts/PairedDevices.tsx
  "pairedDevices.pairedDevices": "Gekoppelte Geräte",
  "pairedDevices.pairADevice": "Gerät koppeln",
  "pairedDevices.notUsedYet": "noch nicht benutzt",
  "pairedDevices.lastUsed": "zuletzt benutzt {used}",
  "pairedDevices.revoke": "{title} sperren",
  "pairedDevices.revoke2": "Sperren",
  "pairedDevices.openPairOnTheDevice":
    "Auf dem Gerät <b>{origin}/pair</b> öffnen und <output>{code}</output> eingeben, bis {expires}. Der Code gilt für ein Gerät, das diese Maschine danach starten und bewegen darf.",
  // app/DraftTools.tsx und panels/drafting/DraftBar.tsx
  "draftTools.whatAClickDoes": "Was ein Klick auf die Zeichnung tut",
  "draftTools.selectEdges": "Kanten auswählen",
  "draftTools.measureKey": "Messen (M)",
  "draftTools.drawALine": "Linie zeichnen",
  "draftTools.drawACircle": "Kreis zeichnen",
  "draftTools.moveEnds": "Enden von Kanten verschieben oder eine Lücke schließen",
  "draftTools.chooseTheUnitFirst": "Zuerst die Einheit der Zeichnung wählen.",
  "draftTools.edgesAreLoading": "Die Kanten werden noch geladen.",
  "draftTools.selectEdgesKey": "Kanten auswählen (V)",
  "draftTools.selectByBoxKey": "Kanten in einem Rahmen auswählen (B)",
  "draftTools.selectByLassoKey": "Kanten mit dem Lasso auswählen (Q)",
  "draftTools.showDimensionsKey": "Maße zeigen (D)",
  "draftBar.keepTheDimension": "Maß behalten",
  "draftBar.drawingTool": "Zeichenwerkzeug",
  "draftBar.chooseTheFirstPoint": "Den ersten Punkt anklicken.",
  "draftBar.chooseTheSecondPoint": "Den zweiten Punkt anklicken.",
  "draftBar.chooseTheStartOfTheLine": "Den Anfang der Linie anklicken.",
  "draftBar.chooseTheEndOfTheLine": "Das Ende der Linie anklicken.",
  "draftBar.chooseTheCentre": "Den Mittelpunkt des Kreises anklicken.",
  "draftBar.chooseAPointOnTheCircle": "Einen Punkt auf dem Kreis anklicken.",
  "draftBar.chooseTheEndToMove":
    "Das Ende einer Kante anklicken. Alle Kanten, die dort enden, werden verschoben, oder nur die ausgewählten.",
  "draftBar.chooseItsNewPlace": "Seine neue Stelle anklicken.",
  "draftBar.lineTypeOfTheNewEdge": "Linienart der neuen Kante",
  "draftBar.leaveTheTool": "Zeichenwerkzeug verlassen",
  "draftBar.setPoint": "Punkt setzen",
  "draftBar.measured": "{distance} mm · X {dx} mm · Y {dy} mm · {angle}°",
  // panels/drawing/ColourBar.tsx
  "colourBar.whatTheColoursOfThe": "Was die Farben der Zeichnung zeigen",
  "colourBar.blueEdgesHave0Mm":
    "{title}: blaue Kanten haben 0 mm, gelbe {limit, number, ::group-off} mm, rote mehr; graue werden weder geschnitten noch gerillt",
  "colourBar.neitherCutNorCreased": "weder geschnitten noch gerillt",
  "colourBar.moreThanMm": "mehr als {limit, number, ::group-off} mm",
  // panels/drawing/DocumentPanel.tsx
  "documentPanel.foldIn3D": "In 3D falten",
  "documentPanel.editTheRulesOfThis": "Regeln dieses Profils bearbeiten",
  "documentPanel.drawingSize": "Größe der Zeichnung",
  "documentPanel.unitUnknown": "{width} × {height}, Einheit unbekannt",
  "documentPanel.sizeInInches": "Größe in Zoll",
  "documentPanel.numberOfEdges": "Anzahl Kanten",
  "documentPanel.withALineTypeSet":
    "{segments, number}, davon {overrides, number} mit von Hand gesetzter Linienart",
  "documentPanel.importReport": "Importbericht",
  "documentPanel.profileRulesForLineTypes": "Profil (Regeln für Linienarten)",
  "documentPanel.deletedProfile": "Gelöschtes Profil",
  "documentPanel.customerProfiles": "Kundenprofile",
  "documentPanel.builtInProfiles": "Mitgelieferte Profile",
  "documentPanel.thisProfileWasDeleted": "Dieses Profil wurde gelöscht",
  "documentPanel.applyTheChangedProfileTo": "Das geänderte Profil auf die Zeichnung anwenden",
  "documentPanel.theProfileHasChangedSince":
    "Das Profil wurde geändert, seit es auf diese Zeichnung angewendet wurde.",
  "documentPanel.thisProfileWasDeletedThe":
    "Dieses Profil wurde gelöscht. Die Zeichnung verwendet noch seine Regeln.",
  // panels/drawing/DrawingsPanel.tsx
  "drawingsPanel.openDrawingFiles": "Zeichnungen öffnen",
  // panels/drawing/EdgeQuestion.tsx
  "edgeQuestion.edges": "{rows, plural, one {# Kante} other {# Kanten}}",
  "edgeQuestion.nothingInTheFileSuggests":
    "Nichts in der Datei weist auf eine Linienart dieser Kanten hin. Linienart wählen.",
  "edgeQuestion.mostLikely": "am wahrscheinlichsten ({percent, number} %)",
  // panels/drawing/FollowingEdges.tsx
  "followingEdges.alsoDecided": "Mit dieser Antwort auch entschieden:",
  "followingEdges.typeByAnswer": "{type}, wenn die Antwort {answer} ist",
  // panels/drawing/EdgeTooltip.tsx
  "edgeTooltip.layerInFile": "Layer in der Datei",
  "edgeTooltip.reasonForLineType": "Grund der Linienart",
  "edgeTooltip.deviationFromDrawing": "Abweichung von der Zeichnung",
  "edgeTooltip.overcutLength": "Länge des Überschnitts",
  "edgeTooltip.uncutLength": "Ungeschnittene Länge",
  "edgeTooltip.gapAtEachEndOf": "Lücke an jedem Ende der Kante",
  "edgeTooltip.toolPathOffTheEdge": "Abstand der Werkzeugbahn von der Kante",
  "edgeTooltip.cornerRoundingByController": "Eckenverrundung der Steuerung",
  "edgeTooltip.edgeOffTheCurveIn": "Abstand der Kante von der Kurve der Datei",
  "edgeTooltip.grooveWidth": "Nutbreite",
  "edgeTooltip.boardThicknessUnderGroove": "Kartondicke unter der Nut",
  "edgeTooltip.positionErrorOfGrooveSides": "Lagefehler der Nutflanken",
  "edgeTooltip.unreachableLength": "Unerreichbare Länge",
  "edgeTooltip.moveAboveBoard": "Weg über dem Karton",
  "edgeTooltip.plungeIntoBoard": "Eintauchen in den Karton",
  "edgeTooltip.leadIn": "Anlauf",
  "edgeTooltip.cutOrCrease": "Schneiden oder Rillen",
  "edgeTooltip.toolTurn": "Drehen des Werkzeugs",
  "edgeTooltip.leadOut": "Auslauf",
  "edgeTooltip.liftOutOfBoard": "Abheben vom Karton",
  "edgeTooltip.toolStation": "Werkzeugstation {tool}",
  "edgeTooltip.tipHeightMm": "Höhe der Spitze {height} mm",
  "edgeTooltip.programLine": "Programmzeile {line, number}",
  "edgeTooltip.andMoreMoves": "… und {rows, number} weitere Wege",
  "edgeTooltip.atTheTopFace": "{width} an der Oberseite",
  "edgeTooltip.upToFromTheCut": "{length}, bis zu {distance} neben dem Schnitt",
  // panels/drawing/Entities.tsx
  "entities.thisObjectHasNoPosition": "Dieses Objekt hat keinen Ort in der Zeichnung",
  "entities.showThePositionOfThis": "Ort dieses Objekts in der Zeichnung zeigen",
  "entities.onLayer": "{handle} auf Layer {layer}",
  "entities.onLayer2": "{kind} {handle} auf Layer {layer}",
  // panels/drawing/ImportPanel.tsx
  "importPanel.kept": "Behalten",
  "importPanel.merged": "Vereint",
  "importPanel.dropped": "Entfernt",
  "importPanel.importReport": "Importbericht",
  "importPanel.all": "Alle",
  "importPanel.listObjectsWithThisImport": "Objekte mit diesem Importergebnis auflisten",
  "importPanel.noObjectOfThisFile":
    "Kein Objekt dieser Datei wurde {outcome, select, kept {behalten} merged {vereint} other {entfernt}}.",
  "importPanel.totalLengthsOfTheLines":
    "Gesamtlängen der Linien, die der Import behalten, vereint und entfernt hat",
  "importPanel.totalLength": "Gesamt",
  "importPanel.keptAsDrawn": "Wie gezeichnet behalten",
  "importPanel.listTheseObjectsOfThe": "Diese Objekte der Datei auflisten",
  "importPanel.edges": "{count, plural, one {# Kante} other {# Kanten}}",
  "importPanel.objects": "{count, plural, one {# Objekt} other {# Objekte}}",
  // panels/drawing/InheritedRules.tsx
  "inheritedRules.rulesTakenFromTheProfile": "Regeln aus dem Profil „{title}“",
  "inheritedRules.rulesEdges":
    "{rules, plural, one {# Regel} other {# Regeln}}, {edges, plural, one {# Kante} other {# Kanten}}",
  // panels/drawing/InspectorPanel.tsx
  "inspectorPanel.selectedEdge": "Ausgewählte Kante {row}",
  "inspectorPanel.selectedEdges":
    "{rows, plural, one {# ausgewählte Kante} other {# ausgewählte Kanten}}",
  "inspectorPanel.andMoreReasonsForThe":
    "… und {more, number} weitere Gründe für die Linienarten der ausgewählten Kanten",
  "inspectorPanel.selectAllEdgesWithThis":
    "Alle {alike, number} Kanten mit diesem Layer und dieser Farbe auswählen",
  "inspectorPanel.edges": "{decided, plural, one {# Kante} other {# Kanten}}",
  "inspectorPanel.confidence": "{confidence, number} % Sicherheit",
  "inspectorPanel.otherPossibleLineTypesClick":
    "Andere mögliche Linienarten (zum Setzen anklicken)",
  "inspectorPanel.objectInFile": "Objekt in der Datei",
  "inspectorPanel.layerInFile": "Layer in der Datei",
  "inspectorPanel.colourInFile": "Farbe in der Datei",
  "inspectorPanel.lineStyleInFile": "Strichart in der Datei",
  "inspectorPanel.lineWidthInFile": "Strichstärke in der Datei",
  "inspectorPanel.importResult": "Importergebnis",
  // panels/drawing/LayersPanel.tsx
  "layersPanel.layersInTheFile": "Layer der Datei",
  "layersPanel.selectAllEdgesOnLayer": "Alle Kanten auf Layer {name} mit Farbe {colour} auswählen",
  "layersPanel.lineTypeOfLayer": "Linienart von Layer {name}",
  "layersPanel.setTheLineTypeOf": "Linienart von Layer {name} setzen",
  "layersPanel.showLayer": "Layer {name} einblenden",
  "layersPanel.hideLayer": "Layer {name} ausblenden",
  // panels/drawing/LearnedPanel.tsx
  "learnedPanel.rulesSuggestedFromTheLine":
    "Vorgeschlagene Regeln aus von Hand gesetzten Linienarten",
  "learnedPanel.treatEveryEdgeThatMatches":
    "Jede Kante, die zu <b>{conditions}</b> passt, als <line>{type}</line> behandeln",
  "learnedPanel.matchesEdgesThatYouSet":
    "Passt zu {explains, plural, one {# von Hand gesetzten Kante} other {# von Hand gesetzten Kanten}}. Keine andere Kante ändert sich.",
  "learnedPanel.matchesEdgesThatYouSet2":
    "Passt zu {explains, plural, one {# von Hand gesetzten Kante} other {# von Hand gesetzten Kanten}}. Setzt auch die Linienart von Kanten, die keine haben:",
  "learnedPanel.matchesEdgesThatYouSet3":
    "Passt zu {explains, plural, one {# von Hand gesetzten Kante} other {# von Hand gesetzten Kanten}}. Ändert auch die Linienart anderer Kanten:",
  "learnedPanel.newProfile": "Neues Profil",
  "learnedPanel.nameOfTheNewProfile": "Name des neuen Profils",
  "learnedPanel.saveRule": "Regel speichern",
  "learnedPanel.addRuleToProfile": "Regel in Profil {title} aufnehmen",
  // panels/drawing/LineTypesPanel.tsx
  "lineTypesPanel.lineTypes": "Linienarten",
  "lineTypesPanel.selectAllEdges": "Alle Kanten der Art „{title}“ auswählen",
  "lineTypesPanel.showEdges": "Kanten der Art „{title}“ einblenden",
  "lineTypesPanel.hideEdges": "Kanten der Art „{title}“ ausblenden",
  // panels/drawing/PagesPanel.tsx
  "pagesPanel.pagesOfTheFile": "Seiten der Datei",
  "pagesPanel.pageIsRead": "Seite {page} ist gelesen",
  "pagesPanel.thePagesCannotBeShown": "Die Seiten können nicht gezeigt werden.",
  "pagesPanel.thePagesAreBeingRead": "Die Seiten werden gelesen …",
  "pagesPanel.chooseAPageToOpen": "Eine Seite wählen, um sie als eigene Zeichnung zu öffnen.",
  "pagesPanel.thePageThatIsRead": "Die gelesene Seite",
  "pagesPanel.page": "Seite {page}",
  "pagesPanel.noDrawing": "keine Zeichnung",
  "pagesPanel.edges": "{edges, plural, one {# Kante} other {# Kanten}}",
  // panels/drawing/PathLegend.tsx
  "pathLegend.toolEntersBoard": "Werkzeug taucht ein",
  "pathLegend.toolTurnsOnTheSpot": "Werkzeug dreht auf der Stelle",
  "pathLegend.toolLeavesBoard": "Werkzeug hebt ab",
  "pathLegend.noCutWidthsToShow":
    "Keine Schnittbreiten zu zeigen: Jedes Werkzeug dieses Programms schneidet auf der Linie selbst.",
  "pathLegend.removesAStripWide": "entfernt einen Streifen von {radius} Breite",
  "pathLegend.cutsAGrooveWideAt":
    "schneidet eine Nut von {depth} Breite an der Oberseite, {depth2} tief",
  "pathLegend.pressesOnOfTheCrease": "drückt auf {radius} der Rille zugleich, {depth} tief",
  // panels/drawing/PreparationBanner.tsx
  "preparationBanner.firstStartOfTheServer":
    "Erster Start des Servers: {compiled, number} von {parts, number} Programmteilen bereit",
  "preparationBanner.firstStartOfTheServer2": "Erster Start des Servers",
  "preparationBanner.theServerPreparesItsSoftware":
    "Der Server bereitet seine Programmteile nur einmal vor, nach der Installation. Arbeiten ist schon möglich: Eine Zeichnung oder ein Auftrag wartet, bis der benötigte Teil bereit ist.",
  // panels/drawing/ProfileEditor.tsx
  "profileEditor.backToTheDrawing": "Zurück zur Zeichnung",
  "profileEditor.thisProfileWasDeletedAnd":
    "Dieses Profil wurde gelöscht und kann nicht bearbeitet werden.",
  "profileEditor.yourUnsavedEditsAreKept": "{back} (ungespeicherte Änderungen bleiben erhalten)",
  "profileEditor.newProfile": "Neues Profil",
  "profileEditor.saveAndApplyToDrawing": "Speichern und anwenden",
  "profileEditor.discardEdits": "Änderungen verwerfen",
  "profileEditor.closeEditor": "Editor schließen",
  "profileEditor.nameOfTheProfile": "Name des Profils",
  "profileEditor.eGNameOfThe": "z. B. Name des Kunden",
  "profileEditor.builtInProfileWhoseRules": "Mitgeliefertes Profil, dessen Regeln auch gelten",
  "profileEditor.noneOnlyTheRulesBelow": "Keines (nur die Regeln unten)",
  "profileEditor.applyTheRulesBelowBefore": "Die Regeln unten vor den mitgelieferten anwenden",
  "profileEditor.rulesTheFirstRuleThat": "Regeln (die erste passende Regel entscheidet)",
  "profileEditor.addRule": "Regel hinzufügen",
  "profileEditor.thisProfileHasNoRules":
    "Dieses Profil hat noch keine eigenen Regeln. Eine Regel hinzufügen, oder Linienarten von Hand setzen und eine Regel speichern, die knifetip vorschlägt.",
  "profileEditor.outcome":
    "{changed, plural, =0 {Diese Regeln ändern keine Linienart in dieser Zeichnung} one {Diese Regeln ändern die Linienart von # Kante in dieser Zeichnung} other {Diese Regeln ändern die Linienart von # Kanten in dieser Zeichnung}}{open, plural, =0 {} one {; zu # Kante passt keine Regel} other {; zu # Kanten passt keine Regel}}.",
  "profileEditor.edgesSetByHandKeep": "Von Hand gesetzte Kanten behalten ihre Linienart.",
  // panels/drawing/ProfileFiles.tsx
  "profileFiles.downloadThisProfileAsA": "Dieses Profil als TOML-Datei herunterladen",
  "profileFiles.importAProfileFromA": "Profil aus einer TOML-Datei importieren",
  "profileFiles.deleteThisProfile": "Dieses Profil löschen",
  // panels/drawing/QuestionTable.tsx
  "questionTable.chooseALineTypeFor":
    "Für jede Zeile eine Linienart wählen und alle auf einmal setzen.",
  "questionTable.layerAndEdges": "Layer und Kanten",
  "questionTable.lineType": "Linienart",
  "questionTable.oneUndoTakesAllOf": "Einmal „Rückgängig“ nimmt alle diese Antworten zurück",
  "questionTable.ofRows":
    "{answers, number} von {questions, plural, one {# Zeile} other {# Zeilen}}",
  "questionTable.setTheChosenLineTypes": "Gewählte Linienarten setzen",
  "questionTable.edges": "{edges, plural, one {# Kante} other {# Kanten}}",
  "questionTable.lineTypeOfEdges":
    "Linienart von {title}, {edges, plural, one {# Kante} other {# Kanten}}",
  "questionTable.choose": "Wählen …",
  // panels/drawing/QuestionsPanel.tsx
  "questionsPanel.openQuestions":
    "{questions, plural, one {# offene Frage} other {# offene Fragen}}",
  "questionsPanel.oneUndoTakesAllOf": "Einmal „Rückgängig“ nimmt alle diese Antworten zurück",
  "questionsPanel.questions": "{suggested, plural, one {# Frage} other {# Fragen}}",
  "questionsPanel.acceptAllMostLikelyLine":
    "Bei allen Fragen die wahrscheinlichste Linienart annehmen",
  "questionsPanel.theEdgesStayVisibleIn":
    "Die Kanten bleiben in der Zeichnung sichtbar, werden aber weder geschnitten noch gerillt",
  "questionsPanel.edges": "{undecided, plural, one {# Kante} other {# Kanten}}",
  "questionsPanel.setAllUndecidedEdgesTo": "Alle offenen Kanten ignorieren",
  // panels/drawing/RuleCard.tsx
  "ruleCard.layerName": "Layername",
  "ruleCard.colour": "Farbe",
  "ruleCard.lineStyleInFile": "Strichart in der Datei",
  "ruleCard.objectTypeInFile": "Objektart in der Datei",
  "ruleCard.blockName": "Blockname",
  "ruleCard.eGFoldsCrease": "z. B. FOLDS, crease*",
  "ruleCard.eG1Ff0000": "z. B. 1, #ff0000",
  "ruleCard.eGDash": "z. B. *DASH*",
  "ruleCard.eGLineArc": "z. B. LINE, ARC",
  "ruleCard.eGCrease": "z. B. *CREASE*",
  "ruleCard.dragToChangeTheOrder": "Ziehen, um die Reihenfolge der Regeln zu ändern",
  "ruleCard.lineTypeOfRule": "Linienart von Regel {number}",
  "ruleCard.edges": "{edges, plural, one {# Kante} other {# Kanten}}",
  "ruleCard.moveThisRuleUpApplied": "Diese Regel nach oben (wirkt früher)",
  "ruleCard.moveThisRuleDownApplied": "Diese Regel nach unten (wirkt später)",
  "ruleCard.deleteThisRule": "Diese Regel löschen",
  "ruleCard.thisRuleHasNoCondition": "Diese Regel hat keine Bedingung: Sie passt zu jeder Kante.",
  "ruleCard.showMoreConditionsForThis": "Weitere Bedingungen dieser Regel zeigen",
  "ruleCard.ofRule": "{condition} von Regel {number}",
  // panels/drawing/Scrubber.tsx
  "scrubber.pauseThePreviewOfThe": "Vorschau des Programms anhalten",
  "scrubber.playAPreviewOfThe": "Vorschau des Programms abspielen",
  "scrubber.timeInThePreviewOf": "Zeit in der Vorschau des Programms",
  "scrubber.machineTimeUpToThe":
    "Maschinenzeit bis zur gezeigten Stelle / Maschinenzeit des ganzen Programms",
  // panels/drawing/SelectionBar.tsx
  "selectionBar.setTheLineTypeOf": "Linienart der ausgewählten Kanten setzen",
  "selectionBar.edgesSelected": "{rows, plural, one {# Kante} other {# Kanten}} ausgewählt",
  "selectionBar.setTheLineTypeTo": "Linienart auf „{title}“ setzen (Taste {key})",
  "selectionBar.setTheLineTypeTo2": "Linienart auf „{title}“ setzen",
  "selectionBar.key0": "{useprofiletype} (Taste 0)",
  "selectionBar.clearTheSelectionOfEdges": "Auswahl der Kanten aufheben",
  // panels/drawing/ShareControl.tsx
  "shareControl.itsOwnerOrAnOperator":
    "Der Besitzer der Zeichnung oder ein Bediener kann sie freigeben.",
  "shareControl.allDesignersMayChangeThis": "Alle Gestalter dürfen diese Zeichnung ändern",
  // panels/drawing/TaughtPanel.tsx
  "taughtPanel.decidedFromAnswers": "Aus früheren Antworten entschieden",
  "taughtPanel.moreEdgesWithTheLook":
    "<b>{rows, plural, one {# weitere Kante} other {# weitere Kanten}}</b> mit Layer, Farbe und Strichart von Kanten, die Sie beantwortet haben",
  "taughtPanel.edges": "{edges, plural, one {# Kante} other {# Kanten}}",
  "taughtPanel.learnedFromOf": "{look}. Gelernt aus {drawings} von {customer}.",
  "taughtPanel.askAboutSuchEdgesIn":
    "Nach solchen Kanten fragen, in dieser Zeichnung und in den nächsten",
  "taughtPanel.takeBackFor": "Antwort für {customer} nicht mehr verwenden",
  "taughtPanel.useAgain": "Antwort wieder verwenden",
  "taughtPanel.noLongerDecidedAs":
    "{look} ({look2}): die Linienart {title} wird nicht mehr vergeben.",
  // panels/drawing/TypeChanges.tsx
  "typeChanges.becomes": "wird zu",
  "typeChanges.edges": "{edges, plural, one {# Kante} other {# Kanten}}",
  // panels/drawing/UnitPanel.tsx
  "unitPanel.unitOfLengthInThe": "Längeneinheit der Datei",
  "unitPanel.warningAboutTheUnit": "Warnung zur Einheit",
  "unitPanel.asInDrawings":
    "Die Datei nennt keine Einheit. Diese wurde für {drawings} dieses Kunden gewählt.",
  "unitPanel.setByHand": "{title}, von Hand gesetzt",
  "unitPanel.letKnifetipDetectTheUnit": "Einheit wieder aus der Datei bestimmen lassen",
  "unitPanel.aLongerBarShowsStronger":
    "Ein längerer Balken steht für stärkere Hinweise auf diese Einheit",
  "unitPanel.thisUnitIsUsed": "Diese Einheit wird verwendet",
  "unitPanel.mostLikely": "am wahrscheinlichsten",
  "unitPanel.hideTheEvidenceForOther": "Hinweise auf andere Einheiten ausblenden",
  "unitPanel.showTheEvidenceForOther": "Hinweise auf andere Einheiten zeigen",
  // panels/drawing/UnitQuestion.tsx
  "unitQuestion.whichUnitOfLengthDoes": "Welche Längeneinheit verwendet die Datei?",
  // panels/drawing/ViewBar.tsx
  "viewBar.drawing": "Zeichnung",
  "viewBar.theEdgesOfTheDrawing": "die Kanten der Zeichnung",
  "viewBar.headPath": "Kopfbahn",
  "viewBar.thePathOfTheMachine": "die Bahn des Maschinenkopfs",
  "viewBar.pathOfToolTip": "Spitzenbahn",
  "viewBar.thePathOfTheTool": "die Bahn der Werkzeugspitze",
  "viewBar.movesAboveBoard": "Leerwege",
  "viewBar.theMovesOfTheMachine": "die Wege des Maschinenkopfs über dem Karton",
  "viewBar.toolWidth": "Werkzeugbreite",
  "viewBar.theAreaThatTheTools": "die Fläche, die die Werkzeuge schneiden oder drücken",
  "viewBar.plungesAndLifts": "Ein- und Austritte",
  "viewBar.thePointsWhereATool":
    "die Punkte, an denen ein Werkzeug eintaucht, auf der Stelle dreht oder abhebt",
  "viewBar.unreachableAreas": "Unerreichbare Flächen",
  "viewBar.areasThatTheToolCannot": "Flächen, die das Werkzeug nicht erreicht",
  "viewBar.chooseWhatTheViewShows": "Wählen, was die Ansicht zeigt",
  "viewBar.prepareTheProgramFirstRight":
    "Zuerst das Programm vorbereiten (rechte Seitenleiste, Neuer Auftrag)",
  "viewBar.showOrHide": "Ein- oder ausblenden: {shows}",
  // panels/history/HistoryPage.tsx
  "historyPage.endedJobs": "Beendete Aufträge",
  "historyPage.statistics": "Statistik",
  "historyPage.tools": "Werkzeuge",
  "historyPage.finished": "Fertig",
  "historyPage.cancelled": "Abgebrochen",
  "historyPage.boardScrapped": "Bogen verworfen",
  "historyPage.interrupted": "Unterbrochen",
  "historyPage.continuedByAnotherJob": "In anderem Auftrag fortgesetzt",
  "historyPage.refused": "Abgelehnt",
  "historyPage.drawingName": "Name der Zeichnung",
  "historyPage.orderNumber": "Auftragsnummer",
  "historyPage.customer": "Kunde",
  "historyPage.allTimes": "Alle Zeiten",
  "historyPage.last24Hours": "Letzte 24 Stunden",
  "historyPage.last7Days": "Letzte 7 Tage",
  "historyPage.last31Days": "Letzte 31 Tage",
  "historyPage.lastYear": "Letztes Jahr",
  "historyPage.history": "Verlauf",
  "historyPage.whatToShow": "Ansicht des Verlaufs",
  "historyPage.machine": "Maschine",
  "historyPage.allMachines": "Alle Maschinen",
  "historyPage.board": "Material",
  "historyPage.allBoards": "Alles Material",
  "historyPage.state": "Zustand",
  "historyPage.allStates": "Alle Zustände",
  "historyPage.period": "Zeitraum",
  "historyPage.noJobMeetsTheseConditions": "Kein Auftrag erfüllt diese Bedingungen.",
  "historyPage.copies": "{copies, plural, one {# Exemplar} other {# Exemplare}}",
  "historyPage.ofCopies":
    "{copiesDone, number} von {copies, plural, one {# Exemplar} other {# Exemplaren}}",
  // panels/history/StatisticsView.tsx
  "statisticsView.days": "Tage",
  "statisticsView.weeks": "Wochen",
  "statisticsView.months": "Monate",
  "statisticsView.cut": "geschnitten",
  "statisticsView.creased": "gerillt",
  "statisticsView.grooved": "genutet",
  "statisticsView.perforated": "perforiert",
  "statisticsView.halfCut": "geritzt",
  "statisticsView.cutAndCreased": "geschnitten und gerillt",
  "statisticsView.weekOf": "Woche vom {text}",
  "statisticsView.lengthOfAPeriod": "Nach Tagen, Wochen oder Monaten",
  "statisticsView.noJobHasRunOn": "In dieser Zeit lief kein Auftrag auf einer Maschine.",
  "statisticsView.copies": "{copies, plural, one {# Exemplar} other {# Exemplare}}",
  "statisticsView.jobsFinished": "{jobs, plural, one {# Auftrag} other {# Aufträge}} fertig",
  "statisticsView.sheets": "Bogen",
  "statisticsView.length": "Länge",
  "statisticsView.onTheMachine": "Zeit auf der Maschine",
  "statisticsView.interrupted": "Unterbrochen",
  "statisticsView.ofRuns":
    "{interruptions, number} von {runs, plural, one {# Lauf} other {# Läufen}} ({interruptedShare, number} %)",
  // panels/history/ToolsView.tsx
  "toolsView.noChangeRecorded": "Kein Wechsel gespeichert",
  "toolsView.changed": "Gewechselt am {changed} ({changedBy})",
  "toolsView.of": "{used} von {life}",
  "toolsView.lifeOfInMetres0": "Standzeit von {name} in Metern, 0 für keine Grenze",
  "toolsView.life": "Standzeit",
  "toolsView.toolChanged": "Werkzeug gewechselt",
  "toolsView.isThereANewTool": "Ist in Station {station} ein neues Werkzeug?",
  "toolsView.theRecordedLengthOfBecomes":
    "Die gespeicherte Länge von {name} wird 0. Nur bestätigen, wenn das Werkzeug gewechselt wurde.",
  "toolsView.toolWasChanged": "Werkzeug wurde gewechselt",
  "toolsView.notChanged": "Nicht gewechselt",
  // panels/job/AcceptForm.tsx
  "acceptForm.theProgramIsSafeYou":
    "Das Programm ist sicher. Diese Linien können so angenommen werden, wie sie gemacht werden:",
  "acceptForm.reason": "Grund",
  "acceptForm.yourName": "Ihr Name",
  "acceptForm.acceptTheSameShortfallsAs":
    "{same, plural, one {Dieselbe # Einschränkung} other {Dieselben # Einschränkungen}} wie zuvor annehmen",
  "acceptForm.acceptShortfalls":
    "{chosen, plural, one {# Einschränkung} other {# Einschränkungen}} annehmen",
  "acceptForm.acceptedOfTheseLinesFor":
    "{names} hat {findings, number} dieser Linien für den Auftrag vom {time} angenommen. Für diesen Auftrag mit eigenem Namen noch einmal annehmen.",
  "acceptForm.unreached":
    "{count, plural, one {# Linie ist für das Werkzeug nicht erreichbar} other {# Linien sind für das Werkzeug nicht erreichbar}}",
  "acceptForm.kerf":
    "{count, plural, one {# Linie wird so breit wie das Werkzeug} other {# Linien werden so breit wie das Werkzeug}}",
  "acceptForm.fold":
    "{count, plural, one {# Linie lässt sich nicht weit genug falten} other {# Linien lassen sich nicht weit genug falten}}",
  "acceptForm.uncut":
    "{count, plural, one {# Linie kann nicht auf ganzer Länge gemacht werden} other {# Linien können nicht auf ganzer Länge gemacht werden}}",
  "acceptForm.beside":
    "{count, plural, one {# Linie biegt enger, als das Werkzeug folgen kann} other {# Linien biegen enger, als das Werkzeug folgen kann}}",
  "acceptForm.near":
    "{count, plural, one {# Linie liegt dicht neben einer anderen Linie} other {# Linien liegen dicht neben anderen Linien}}",
  "acceptForm.deviation":
    "{count, plural, one {# Linie weicht von der gezeichneten Kurve ab} other {# Linien weichen von der gezeichneten Kurve ab}}",
  "acceptForm.other": "{count, plural, one {# Linie} other {# Linien}}: {kind}",
  // panels/handover/Handover.tsx
  "handover.jobTicket": "Auftragszettel",
  "handover.exportDrawing": "Exportieren",
  "handover.exportPath": "Werkzeugbahn exportieren",

  // panels/handover/ExportMenu.tsx
  "exportMenu.pdf": "PDF (wahre Größe)",
  "exportMenu.svg": "SVG (wahre Größe)",
  "exportMenu.dxf": "DXF (mit Layern)",
  "exportMenu.png": "PNG-Bild",

  // panels/job/JobPanel.tsx
  "jobPanel.showTheDrawingWithoutAJob": "Die Zeichnung ohne Auftrag zeigen",
  "jobPanel.openJob": "Geöffneter Auftrag",
  "jobPanel.downloadRefusedProgramLines":
    "Abgelehntes Programm herunterladen ({lines, plural, one {# Zeile} other {# Zeilen}})",
  "jobPanel.downloadMachineProgramLines":
    "Maschinenprogramm herunterladen ({lines, plural, one {# Zeile} other {# Zeilen}})",
  "jobPanel.board": "Material: <b>{title}</b> · {machine}",
  "jobPanel.restOfTheSheetOr": "Diesen Bogen fortsetzen oder ein Exemplar mehr machen",
  "jobPanel.theJobWaitsForThe": "Der Auftrag wartet auf die Maschine {machine}.",
  "jobPanel.progressOfTheJobOn": "Fortschritt des Auftrags auf dem Tisch",
  "jobPanel.done": "{progress, number} % fertig",
  "jobPanel.copyOf": "Exemplar {copiesDone, number} von {copies, number}",
  "jobPanel.programLineOf": "Programmzeile {line, number} von {lines, number}",
  "jobPanel.left": "noch {left}",
  "jobPanel.copiesFinished": "{copies, plural, one {# Exemplar} other {# Exemplare}} fertig",
  "jobPanel.theTableIsFreeFor": "Der Tisch ist frei für den nächsten Auftrag.",
  "jobPanel.theJobWasCancelled": "Der Auftrag wurde abgebrochen.",
  "jobPanel.showEdgesInTheDrawing":
    "{rows, plural, one {# Kante} other {# Kanten}} in der Zeichnung zeigen",
  "jobPanel.sendJobToMachine": "Auftrag an Maschine senden",
  "jobPanel.compileJobAgain": "Auftrag neu berechnen",
  "jobPanel.pauseJob": "Auftrag anhalten",
  "jobPanel.cancelJob": "Auftrag abbrechen",
  "jobPanel.markJobAsFinished": "Auftrag als fertig melden",
  "jobPanel.letTheMachineTryAgain": "Maschine noch einmal versuchen lassen",
  "jobPanel.queueJobAgain": "Auftrag noch einmal einreihen",
  "jobPanel.endJobBoardIsScrap": "Auftrag beenden, Bogen ist Ausschuss",
  // panels/job/MachineChip.tsx
  "machineChip.theKnifetipServerDoesNot":
    "Der knifetip-Server antwortet nicht. Die Seite versucht weiter, ihn zu erreichen.",
  "machineChip.loadingTheListOfMachines": "Liste der Maschinen wird geladen",
  "machineChip.offline": "nicht verbunden",
  "machineChip.free": "frei",
  "machineChip.waiting": "wartet",
  "machineChip.interrupted": "unterbrochen",
  "machineChip.busy": "beschäftigt",
  // panels/job/MachinePanel.tsx
  "machinePanel.carriageAxes": "Schlitten {number}: Achsen {axes}",
  "machinePanel.parksAtMm": "parkt bei {axis} {park} mm",
  "machinePanel.xTo": "X {x} bis {x2}",
  "machinePanel.yTo": "Y {y} bis {y2}",
  "machinePanel.mmHigh": "{top, number, ::group-off} mm hoch",
  "machinePanel.webhooks": "Webhooks",
  "machinePanel.controllerLanguage": "{title}, Steuerungssprache {language}",
  "machinePanel.keepOutZonesWhichNo": "Sperrzonen, die kein Werkzeug berühren darf",
  // panels/job/MachineQueue.tsx
  "machineQueue.queueOf": "Warteschlange: {title}",
  "machineQueue.waiting": "{ids, plural, one {# wartet} other {# warten}}",
  "machineQueue.noJobWaitsForThis": "Kein Auftrag wartet auf diese Maschine.",
  "machineQueue.copiesDone":
    "{copies, plural, one {# Exemplar} other {# Exemplare}}, {copiesDone, number} fertig",
  "machineQueue.copies": "{copies, plural, one {# Exemplar} other {# Exemplare}}",
  "machineQueue.progressOf": "Fortschritt von {drawingName}",
  "machineQueue.howToMove":
    "Mit der Leertaste den Auftrag aufnehmen, mit den Pfeiltasten verschieben und mit der Leertaste ablegen; Esc bricht ab.",
  "machineQueue.drag": "Auftrag {place} verschieben: {name}",
  "machineQueue.moveUp": "{name} nach oben",
  "machineQueue.moveDown": "{name} nach unten",
  "machineQueue.endTheHoldOf": "{name} nicht mehr zurückstellen",
  "machineQueue.holdInTheQueue": "{name} in der Warteschlange zurückstellen",
  "machineQueue.copiesOf": "Exemplare von {name}",
  "machineQueue.priorityAndMachineOf": "Priorität und Maschine von {name}",
  "machineQueue.moveToTheTop": "Ganz nach oben",
  "machineQueue.priority": "Priorität",
  "machineQueue.moveToMachine": "Auf andere Maschine",
  // panels/job/QueuePanel.tsx
  "queuePanel.copies": "{copies, number} Exemplare",
  "queuePanel.machineTime": "Maschinenzeit {seconds}",
  "queuePanel.progressOf": "Fortschritt von {drawingName}",
  // panels/job/RemainingCopies.tsx
  "remainingCopies.queueTheRemainingCopies":
    "{remainingCopies, plural, one {Das übrige Exemplar} other {Die übrigen # Exemplare}} einreihen",
  // panels/job/RestPanel.tsx
  "restPanel.continueFromHere": "Ab hier fortsetzen",
  "restPanel.onlyThisTool": "Nur dieses Werkzeug",
  "restPanel.oneMoreCopy": "Ein Exemplar mehr",
  "restPanel.cut": "geschnitten",
  "restPanel.begun": "begonnen",
  "restPanel.notCut": "nicht geschnitten",
  "restPanel.notKnown": "unbekannt",
  "restPanel.orBeginAtAProgram": "Oder an einer Programmzeile beginnen",
  "restPanel.theNewJobBeginsWith": "Der neue Auftrag beginnt mit der Bahn dieser Zeile.",
  "restPanel.line": "Zeile",
  "restPanel.iHaveCheckedOnThe":
    "Am Bogen geprüft: {count, plural, one {# ausgelassene Bahn ({tracks}) ist} other {# ausgelassene Bahnen ({tracks}) sind}} vollständig gemacht",
  "restPanel.iHaveCheckedOnThe2":
    "Am Bogen geprüft: {count, plural, one {# als geschnitten gemeldete Bahn ({tracks}) hat} other {# als geschnitten gemeldete Bahnen ({tracks}) haben}} den Karton nicht durchtrennt",
  "restPanel.queueOneMoreCopy": "Ein Exemplar mehr einreihen",
  "restPanel.continueThisSheetTracksLeft":
    "Bogen fortsetzen, {chosen, plural, one {noch # Bahn} other {noch # Bahnen}}",
  "restPanel.itIsNotKnownHow":
    "Es ist nicht bekannt, wie weit die Maschine gekommen ist. Den Bogen ansehen und für {unknown, plural, one {diese # Bahn} other {jede dieser # Bahnen}} angeben, ob sie vollständig gemacht ist. Eine Bahn im Bild antippen oder in der Liste antworten.",
  "restPanel.station": "Station {station}",
  "restPanel.made": "Gemacht",
  "restPanel.notMade": "Nicht gemacht",
  "restPanel.tracksNotAnsweredYet":
    "{open, plural, one {# Bahn} other {# Bahnen}} noch nicht beantwortet.",
  "restPanel.allTracksAreMadeMark":
    "Alle Bahnen sind gemacht. Den Auftrag unten als fertig melden.",
  "restPanel.leaveTheSheetInIts":
    "Den Bogen liegen lassen. Ein neuer Auftrag macht {chosen, number} von {all, plural, one {# Bahn} other {# Bahnen}}: {tracks}.",
  "restPanel.makeOneMoreCopyOn": "Stattdessen ein Exemplar mehr auf neuem Bogen",
  "restPanel.clearTheTableANew":
    "Den Tisch räumen. Ein neuer Auftrag macht das ganze Programm noch einmal auf einem neuen Bogen.",
  "restPanel.theTrackThatWasBegun":
    "Die begonnene Bahn wird von ihrem Anfang an noch einmal gemacht.",
  "restPanel.tracksReportedAsCutWill":
    "{count, plural, one {# als geschnitten gemeldete Bahn wird} other {# als geschnitten gemeldete Bahnen werden}} noch einmal gemacht: {tracks}.",
  "restPanel.tracksOfTheProgramOn": "Bahnen des Programms auf dem Bogen",
  "restPanel.trackStation": "Bahn {number}, Station {station}, {state}",
  "restPanel.willBeMade": "wird gemacht",
  "restPanel.lines": "Zeilen {firstLine} – {lastLine}",
  // panels/job/VerdictCard.tsx
  "verdictCard.resultOfTheProgramCheck": "Ergebnis der Programmprüfung",
  "verdictCard.longestOvercut": "Längster Überschnitt",
  "verdictCard.longestLengthLeftUncut": "Längste ungeschnittene Strecke",
  "verdictCard.totalLengthLeftOutAs": "Absichtlich ausgelassene Gesamtlänge",
  "verdictCard.machineTime": "Maschinenzeit",
  "verdictCard.andMoreFindings":
    "… und {findings, plural, one {# weiterer Befund} other {# weitere Befunde}}.",
  "verdictCard.programHasErrorsAndCannot": "Programm hat Fehler und kann nicht gesendet werden",
  "verdictCard.toolCannotMakeLines":
    "Das Werkzeug kann {shortfalls, plural, one {# Linie} other {# Linien}} nicht wie gezeichnet fertigen; die anderen schneidet es auf {deviation} genau in {seconds}",
  "verdictCard.acceptThem": "So annehmen …",
  "verdictCard.andAtMorePlaces":
    "{text} Das gilt auch an {places, plural, one {# weiteren Stelle} other {# weiteren Stellen}}.",
  "verdictCard.error": "Fehler",
  "verdictCard.shortfall": "Einschränkung",
  "verdictCard.note": "Hinweis",
  "verdictCard.ofTheCutLinesCannot":
    "{unreachedLength} der Schnittlinien sind für das Werkzeug nicht erreichbar. Sie liegen bis zu {unreachedDistance} neben dem Schnitt.",
  "verdictCard.inSlitsBecomeAsWide":
    "{slitPlaces, plural, one {# Schlitz wird} other {# Schlitze werden}} auf {slitLength} so breit wie das Werkzeug geschnitten.",
  "verdictCard.inPlacesCannotBeReached":
    "{unreached} an {unreachedPlaces, plural, one {# Stelle} other {# Stellen}} sind für das Werkzeug nicht erreichbar und bleiben ungeschnitten.",
  "verdictCard.liftingTheToolOnlyAs":
    "Das Werkzeug zwischen Schnitten nur so hoch wie nötig zu heben spart {retracted} ({share, number} %).",
  "verdictCard.largestDeviationFromTheDrawing": "Größte Abweichung von der Zeichnung",
  "verdictCard.isTheLargestAllowedDeviation": "{tolerance} ist die größte zulässige Abweichung",
  "verdictCard.acceptedBy": "Angenommen von {by}: {reason}",
  "verdictCard.edge": "Kante {edge}",
  "verdictCard.programLine": "Programmzeile {line}",
  // panels/job/WaitsAtMachine.tsx
  "waitsAtMachine.theOperatorStatesThereWhen":
    "Dort bestätigt der Bediener, wenn die Maschine fertig ist.",
  "waitsAtMachine.copyOfIsFinishedThe":
    "Exemplar {copiesDone, number} von {copies, number} ist fertig. Das nächste braucht einen neuen Bogen.",
  "waitsAtMachine.tableBoardAndToolsAre":
    "Dort prüft der Bediener zuerst Tisch, Karton und Werkzeuge.",
  "waitsAtMachine.theJobIsPausedAnd":
    "Der Auftrag ist angehalten. Der Bediener setzt ihn dort fort.",
  "waitsAtMachine.waitsForTheOperatorAt": "Wartet auf den Bediener an {machine}.",
  "waitsAtMachine.boardOnTheTable": "Karton auf dem Tisch",
  "waitsAtMachine.sheet": "Bogen {sheet}",
  "waitsAtMachine.copyOf": "Exemplar {copiesDone, number} von {copies, number}",
  "waitsAtMachine.toolsInTheStations": "Werkzeuge in den Stationen",
  "waitsAtMachine.stationOf": "Station von {machine}",
  // panels/library/CalibrationForm.tsx
  "calibrationForm.directionOfTravel": "Fahrtrichtung (°)",
  "calibrationForm.offsetInXMm": "Versatz in X (mm)",
  "calibrationForm.offsetInYMm": "Versatz in Y (mm)",
  "calibrationForm.noMachineHasACutter":
    "Keine Maschine hat einen Fräser; es gibt nichts zu kalibrieren.",
  "calibrationForm.computeTheDeflectionFromA": "Durchbiegung aus einem Probeschnitt berechnen",
  "calibrationForm.cutAContourWithoutCompensation":
    "Eine Kontur ohne Korrektur schneiden. Messen, wie weit die geschnittene von der gezeichneten Kontur liegt, an Kanten längs X, längs Y und unter 45°.",
  "calibrationForm.cutter": "Fräser",
  "calibrationForm.sideOfTheContourOn": "Seite der Kontur, auf der der Fräser lief",
  "calibrationForm.leftAsInProgramsOf": "Links, wie in Programmen von knifetip",
  "calibrationForm.right": "Rechts",
  "calibrationForm.ofPoint": "{label} von Punkt {at, number}",
  "calibrationForm.addPoint": "Punkt hinzufügen",
  "calibrationForm.compute": "Berechnen",
  "calibrationForm.mmInXMmIn":
    "Durchbiegung von {tool}: {x} mm in X, {y} mm in Y. Die Messpunkte weichen höchstens {residual} mm davon ab.",
  "calibrationForm.useTheseValues": "Diese Werte verwenden",
  // panels/library/ConflictCard.tsx
  "conflictCard.version": "Version {version}",
  "conflictCard.yours": "Eigene",
  "conflictCard.discardMyChangesAndLoad": "Eigene Änderungen verwerfen und Version {version} laden",
  "conflictCard.saveMyChangesAsVersion": "Eigene Änderungen als Version {version} speichern",
  "conflictCard.anotherUser": "Ein anderer Benutzer",
  "conflictCard.hasSavedVersionSinceYou":
    "{by} hat inzwischen Version {version} gespeichert. Die eigenen Änderungen sind nicht gespeichert.",
  // panels/library/CopyForm.tsx
  "copyForm.giveItAName": "Einen Namen eingeben.",
  "copyForm.aNameHasSmallLetters":
    "Ein Name hat Kleinbuchstaben, Ziffern, Binde- und Unterstriche.",
  "copyForm.thereIsAWithThis":
    "{shelf, select, machines {Eine Maschine} boards {Ein Material} other {Ein Werkzeug}} mit diesem Namen gibt es schon. Einen anderen Namen wählen.",
  "copyForm.copiedFrom": "kopiert von {title}",
  "copyForm.copy": "{title} kopieren",
  "copyForm.titleOfTheCopy": "Titel der Kopie",
  "copyForm.asItIsShownIn": "Wie er in Listen erscheint",
  "copyForm.giveItATitle": "Einen Titel eingeben.",
  "copyForm.nameOfTheCopy": "Name der Kopie",
  "copyForm.forGatewaysFilesAndRequests":
    "Bezeichnet die Kopie in Dateien und Anfragen. Er kann später nicht geändert werden.",
  "copyForm.makeTheCopy": "Kopie anlegen",
  "copyForm.cancel": "Abbrechen",
  // panels/library/DimensionPicture.tsx
  "dimensionPicture.dimensions": "Maße",

  // panels/library/testpieces
  "testPieces.after": "Neu",
  "testPieces.before": "Jetzt",
  "testPieces.compute": "Einstellungen berechnen",
  "testPieces.copyItFirst":
    "{name} gehört zu knifetip und ist schreibgeschützt. Eine Kopie anlegen und diese vermessen.",
  "testPieces.difference": "Unterschied {value} ± {uncertainty}",
  "testPieces.inTheController":
    "In der Steuerung oder am Portal einstellen; keine Datei enthält es.",
  "testPieces.machine": "Maschine",
  "testPieces.measureWithATestPiece": "Mit Teststück vermessen",
  "testPieces.noTool":
    "Kein Teststück passt zu einem Werkzeug dieser Maschine. Eine andere Maschine wählen.",
  "testPieces.notSignificant": "Ändert sich um weniger als seine Unsicherheit",
  "testPieces.noteOf": "Teststück: {name}",
  "testPieces.openTheOrder": "Zeichnen und Auftrag öffnen",
  "testPieces.orderedLikeAnyDrawing":
    "Das Stück wird wie jede Zeichnung bestellt und geprüft; die Tiefen seiner Linien sind Angaben des Auftrags. Nach dem Schneiden hierher zurückkehren.",
  "testPieces.pictureOf": "Teststück {name} mit Pfeilen für die Maße",
  "testPieces.saveAsNewVersion": "In {name} als neue Version speichern",
  "testPieces.saved":
    "In {name} als Version {version} gespeichert. Die Liste der Versionen kann es zurücknehmen.",
  "testPieces.setting": "Einstellung",
  "testPieces.station": "Station",
  "testPieces.stepChoose": "1. Werkzeug, Material und Teststück wählen",
  "testPieces.stepMeasure": "3. Das Stück messen",
  "testPieces.stepOrder": "2. Das Stück schneiden",
  "testPieces.stepSave": "4. Vergleichen und speichern",
  "testPieces.testPiece": "Teststück",

  // panels/library/DefinitionEditor.tsx
  "definitionEditor.loading": "Wird geladen …",
  "definitionEditor.allFaults": "Alle Korrekturen zeigen",
  "definitionEditor.notSavedValuesNeedA":
    "Nicht gespeichert. {count, plural, one {# Wert muss} other {# Werte müssen}} korrigiert werden; jeder ist im Formular markiert.",
  "definitionEditor.allEntries": "Alle Einträge",
  "definitionEditor.suppliedWithKnifetip": "mit knifetip geliefert",
  "definitionEditor.version": "Version {version}",
  "definitionEditor.copy": "Kopieren",
  "definitionEditor.downloadToml": "TOML herunterladen",
  "definitionEditor.deleteNow": "Jetzt löschen",
  "definitionEditor.delete": "Löschen",
  "definitionEditor.thisEntryIsReadOnly":
    "Dieser Eintrag ist schreibgeschützt. Zum Ändern kopieren.",
  "definitionEditor.more": "Weitere",
  "definitionEditor.save": "Speichern",
  "definitionEditor.whatIsChangedAndWhy": "Was geändert wurde, und warum",
  "definitionEditor.saveAsVersion": "Als Version {version} speichern",
  // panels/library/DefinitionForm.tsx
  "definitionForm.thisControllerLanguageHasNo": "Diese Steuerungssprache hat keine Einstellungen.",
  "definitionForm.theSettingsOfThisController":
    "Die Einstellungen dieser Steuerungssprache können in der TOML-Datei geändert werden.",
  "definitionForm.name": "Name",
  "definitionForm.none": "{label}: keine",
  "definitionForm.add": "Hinzufügen: {label}",
  "definitionForm.remove": "Entfernen: {label}",
  "definitionForm.remove2": "{word} {at, number} entfernen",
  "definitionForm.add2": "{word} hinzufügen",
  "definitionForm.remove3": "{key} entfernen",
  "definitionForm.add3": "Hinzufügen",
  // panels/library/DefinitionHistory.tsx
  "definitionHistory.restore": "Version {compared} wiederherstellen",
  "definitionHistory.restoredFrom": "Version {version} wiederhergestellt",
  "definitionHistory.versions": "Versionen",
  "definitionHistory.compare": "Vergleichen",
  "definitionHistory.version": "Version {compared}",
  "definitionHistory.version2": "Version {version}",
  // panels/library/DifferenceTable.tsx
  "differenceTable.field": "Feld",
  // panels/library/ToolPicker.tsx
  "toolPicker.takeAToolFromThe": "Werkzeug aus der Bibliothek übernehmen",
  "toolPicker.itsDimensionsAndFeedRates":
    "Seine Maße und Vorschübe werden in diese Station kopiert.",
  "toolPicker.chooseATool": "Werkzeug wählen",
  // panels/order/BoardSelect.tsx
  "boardSelect.board": "Material",
  "boardSelect.asInTheLastJob": "Wie im letzten Auftrag dieser Zeichnung",
  "boardSelect.chooseTheBoard": "Material wählen",
  "boardSelect.asLastTimeFor": "Wie zuletzt für {customer}: {title}",
  // panels/order/CornersForm.tsx
  "cornersForm.automatic": "Automatisch",
  "cornersForm.arcB": "Kreisbogen (B)",
  "cornersForm.straightWithStopC": "Gerade mit Halt (C)",
  "cornersForm.blendD": "Übergang (D)",
  "cornersForm.forEachCornerKnifetipChooses": "Für jede Ecke wählt knifetip den schnellsten Weg.",
  "cornersForm.theCentreOfTheTool":
    "Die Mitte des Werkzeugs folgt einem Bogen um die Ecke; das Werkzeug berührt die Ecke die ganze Zeit.",
  "cornersForm.theCentreOfTheTool2":
    "Die Mitte des Werkzeugs fährt gerade über die Ecke hinaus, hält und fährt in der neuen Richtung weiter.",
  "cornersForm.theCentreOfTheTool3":
    "Die Mitte des Werkzeugs fährt gerade über die Ecke hinaus und wechselt die Richtung auf einem kleinen Bogen, ohne Halt.",
  "cornersForm.parameterKOfTheTool":
    "Parameter k der Werkzeugbahn an der Ecke (0 = Bogen wie in Art B, 1 = gerade mit Halt wie in Art C)",
  "cornersForm.toolPathAtOuterCorners": "Werkzeugbahn an Außenecken",
  "cornersForm.whereTheToolIsToo": "Wo das Werkzeug für einen Teil der Kontur zu breit ist",
  "cornersForm.leaveThisPartUncut": "Diesen Teil ungeschnitten lassen",
  "cornersForm.doNotCreateAProgram": "Kein Programm erstellen",
  "cornersForm.inTheDrawingClickA":
    "In der Zeichnung einen Schnitt nahe der Ecke anklicken, deren Werkzeugbahn gewählt werden soll.",
  "cornersForm.finishChoosingCorners": "Auswahl der Ecken beenden",
  "cornersForm.chooseThePathForIndividual": "Bahn für einzelne Ecken wählen",
  "cornersForm.toolPathAtTheCorner": "Werkzeugbahn an der Ecke bei {one}",
  "cornersForm.resetTheToolPathAt": "Werkzeugbahn an der Ecke bei {one} zurücksetzen",
  "cornersForm.position": "{x}, {y} mm",
  // panels/order/CustomerField.tsx
  "customerField.customer": "Kunde",
  "customerField.answersAreRememberedForEach": "Antworten werden je Kunde gemerkt",
  // panels/order/OrderDetails.tsx
  "orderDetails.overdueSince": "überfällig seit {due}",
  "orderDetails.due": "fällig {due}",
  // panels/order/OrderDetailsForm.tsx
  "orderDetailsForm.orderDetails": "Auftragsdaten: {externalId}",
  "orderDetailsForm.orderDetails2": "Auftragsdaten",
  "orderDetailsForm.orderNumber": "Auftragsnummer",
  "orderDetailsForm.customer": "Kunde",
  "orderDetailsForm.due": "Fällig",
  "orderDetailsForm.notes": "Notizen",
  // panels/order/OrderPanel.tsx
  "orderPanel.machine": "Maschine",
  "orderPanel.chooseAMachine2": "Maschine wählen",
  "orderPanel.leastLiftInTurnsMm":
    "Werkzeuge zum Drehen nur {turnClearance, number, ::group-off} mm über den Karton heben",
  "orderPanel.savesTimeOnlyForBoard": "Spart Zeit. Nur für Karton, der flach auf dem Tisch liegt.",
  "option.feed_factor": "Vorschubfaktor (0,1 bis 1)",
  "option.feed_factor.description":
    "Kleiner als 1 ist langsamer: für Karton, der reißt, oder ein abgenutztes Werkzeug. Ein Laser schneidet dann tiefer",
  "option.warp": "Verzug des Kartons (mm)",
  "option.warp.description":
    "So weit hebt sich verzogener Karton vom Tisch: Werkzeuge tauchen um so viel höher ein, drehen und fahren höher. 0 für flach liegenden Karton",
  "option.program_note": "Notiz im Programm",
  "option.program_note.description":
    "Kommentar am Anfang des Programms, für die Person an der Steuerung, etwa welche Seite oben liegt",
  "fact.program_bytes": "Größe des Programms",
  "fact.worked_length": "Arbeit je Exemplar",
  "option.on": "Ja",
  "option.off": "Nein",
  "orderPanel.copies": "Exemplare",
  "orderPanel.prepareProgram": "Vorbereiten",
  "orderPanel.prepareAgain": "Neu vorbereiten",
  // panels/order/EdgeOptions.tsx: options of edges, by the names of options and fields
  "edgeOption.forTheNextJob": "Für den nächsten Auftrag dieser Zeichnung:",
  "edgeOption.selectedEdges": "{n, plural, one {Diese Kante} other {Diese # Kanten}}",
  "edgeOption.allOfType": "Alle: {type}",
  "edgeOption.fromStart": "{share} der Kante, {length} mm ab ihrem Anfang",
  "edgeOption.asUsual": "Standard",
  "edgeOption.millimetres": "{value} mm",
  "edgeOption.station": "Station {number}",
  "edgeOption.choicesForEdges": "Vorgaben für Kanten",
  "edgeOption.edges": "{n, plural, one {Kante {edge}} other {# Kanten}}",
  "edgeOption.remove": "Entfernen: {subject}",
  "edgeOption.contour_starts": "Start und Richtung",
  "edgeOption.contour_starts.at": "Schnitt beginnt hier",
  "edgeOption.contour_starts.direction": "Richtung",
  "edgeOption.contour_starts.direction.free": "Frei",
  "edgeOption.contour_starts.direction.forward": "Vorwärts",
  "edgeOption.contour_starts.direction.reverse": "Rückwärts",
  "edgeOption.cut_depths": "Durchgänge und Tiefe",
  "edgeOption.cut_depths.passes": "Durchgänge",
  "edgeOption.cut_depths.depth": "Tiefe unter der Oberseite",
  "edgeOption.crease_depths": "Tiefe von Rillungen",
  "edgeOption.crease_depths.depth": "Rilltiefe",
  "edgeOption.edge_tools": "Werkzeug der Kanten",
  "edgeOption.edge_tools.help":
    "Rillungen, die einander fortsetzen, brauchen dasselbe Rillrad. Ein Fräser oder Laser bearbeitet die ganze Kontur einer Kante.",
  "edgeOption.edge_tools.station": "Werkzeug",
  "edgeOption.edge_corners": "Ecken der Kanten",
  "edgeOption.edge_corners.help":
    "Eine Ecke hat die Art der Kante, auf der das Werkzeug ankommt: Es läuft im Uhrzeigersinn um Teile und gegen ihn in Löchern. Eine Art für eine einzelne Ecke geht vor.",
  "edgeOption.edge_corners.type": "Eckenart",
  "edgeOption.edge_corners.type.usual": "Wie im Auftrag",
  "edgeOption.edge_corners.type.auto": "Automatisch",
  "edgeOption.edge_corners.type.B": "Bogen (B)",
  "edgeOption.edge_corners.type.C": "Gerade (C)",
  "edgeOption.edge_corners.type.D": "Übergang (D)",
  "edgeOption.edge_corners.k": "Parameter k der Art D",
  "edgeOption.contour_leads": "Anlauf von Konturen",
  "edgeOption.contour_leads.help":
    "Für Fräser und Laser, für die ganze Kontur einer Kante. Wo kein Platz ist, wird der Anlauf halbiert oder weggelassen.",
  "edgeOption.contour_leads.length": "Länge des Anlaufs",
  "edgeOption.contour_leads.approach": "Winkel zur Kontur",
  "edgeOption.edge_feeds": "Vorschub der Kanten",
  "edgeOption.edge_feeds.factor": "Vorschubfaktor",
  // panels/order/SheetForm.tsx
  "marksForm.marks": "Marken eines gedruckten Bogens",
  "marksForm.note":
    "Kleine Kreise, Kreuze oder Linienenden in der Zeichnung anklicken oder auswählen. Ihre Mitten werden an der Maschine gemessen, und der Auftrag folgt dem Druck.",
  "marksForm.take": "Mitten der ausgewählten Linien nehmen",
  "marksForm.pick": "Marken in der Zeichnung anklicken",
  "marksForm.finish": "Anklicken beenden",
  "marksForm.noPoint": "Hier ist kein Linienende, keine Kreismitte und keine Kreuzung.",
  "marksForm.none": "Die Auswahl enthält keinen Kreis und keine Kreuzung.",
  "marksForm.close": "Marken müssen mindestens 20 mm auseinander liegen.",
  "marksForm.one": "Eine zweite Marke fehlt.",
  "marksForm.mark": "Marke {number}: X {x}, Y {y} mm",
  "marksForm.remove": "Marke {number} entfernen",
  "marksForm.keep": "Größe der Zeichnung beibehalten (Maßstab 1)",
  "marksPanel.title": "Gedruckten Bogen messen",
  "marksPanel.note":
    "Mit den Pfeilen über jede Marke fahren und die Position übernehmen. Der Auftrag wird dann für den Bogen berechnet, wie er liegt.",
  "marksPanel.aim": "Was über der Marke steht",
  "marksPanel.head": "Achse des Kopfes",
  "marksPanel.mark": "Marke {number}",
  "marksPanel.expected": "erwartet bei X {x}, Y {y} mm",
  "marksPanel.taken": "übernommen bei X {x}, Y {y} mm",
  "marksPanel.take": "Übernehmen",
  "marksPanel.noPosition": "Die Maschine meldet ihre Position nicht.",
  "marksPanel.fit":
    "Verschiebung X {x}, Y {y} mm · Drehung {turn}° · Maßstab {scale} · größter Fehler {error} mm",
  "marksPanel.turned":
    "Der Bogen liegt um {turn}° gedreht. Wurden die Marken in der richtigen Reihenfolge übernommen?",
  "marksPanel.error": "Fehler {error} mm",
  "marksPanel.compile": "Für diesen Bogen berechnen",
  "marksPanel.forget": "Der Bogen liegt an den Anschlägen",
  "marksPanel.forgetNote": "Verwirft die gemessenen Marken.",
  "marksPanel.compileNote":
    "Der Auftrag kommt mit einem neu geprüften Programm an diesen Tisch zurück.",
  "marksPanel.camera": "Kamerabild",
  "marksPanel.cameraOff": "Kamerabild schließen",
  "marksPanel.noCamera": "Dieser Rechner hat keine Kamera, oder der Browser erlaubt sie nicht.",
  "marksPanel.picture":
    "Bogen auf dem Tisch: Marken der Zeichnung als Kreise, gemessene Marken als Kreuze",
  "sheetForm.largerThanTheDrawing": "Größer als die Zeichnung",
  "sheetForm.cutToTheOutlineOf": "Auf die Außenkontur der Zeichnung zugeschnitten",
  "sheetForm.cutToARectangle": "Auf ein Rechteck zugeschnitten",
  "sheetForm.widthMm": "Breite (mm)",
  "sheetForm.heightMm": "Höhe (mm)",
  "sheetForm.marginMm": "Rand (mm)",
  "sheetForm.sheet": "Bogen",
  "sheetForm.theDrawingWithItsMargin":
    "Die Zeichnung mit ihrem Rand passt nicht auf den Bogen: Sie braucht {width}.",
  "sheetForm.besideTheSheetToolsTurn":
    "Neben dem Bogen drehen Werkzeuge ohne Abheben. Nur einen Bogen auflegen, der auf diese Außenkontur zugeschnitten ist.",
  "sheetForm.besideTheSheetToolsTurn2":
    "Neben dem Bogen drehen Werkzeuge ohne Abheben. Der Rand ist der Abstand der Zeichnung vom linken und unteren Rand des Bogens. Nur einen Bogen dieser Größe auflegen.",
  // panels/shared/LanguageMenu.tsx
  "languageMenu.language": "Sprache",
  // panels/shared/NotificationList.tsx
  "notificationList.showEdgesInTheDrawing":
    "{rows, plural, one {# Kante} other {# Kanten}} in der Zeichnung zeigen",
  "notificationList.closeThisMessage": "Meldung schließen",
  // panels/shared/ProgressOverlay.tsx
  "progressOverlay.waitingForTheServer": "Warten auf den Server",
  "progressOverlay.uploaded": "{fraction, number} % hochgeladen",
  "progressOverlay.readingTheFile": "Datei wird gelesen …",
  "progressOverlay.uploadOf": "Hochladen von {name}",
  // panels/shared/ShortcutsDialog.tsx
  "shortcutsDialog.showTheWholeDrawing": "Ganze Zeichnung zeigen",
  "shortcutsDialog.showTheWholeTable": "Ganzen Tisch zeigen",
  "shortcutsDialog.moveTheView": "Ansicht verschieben",
  "shortcutsDialog.undoTheLastChange": "Letzte Änderung rückgängig machen",
  "shortcutsDialog.redoTheUndoneChange": "Rückgängig gemachte Änderung wiederholen",
  "shortcutsDialog.esc": "Esc",
  "shortcutsDialog.clearTheSelectionOfEdges": "Auswahl der Kanten aufheben",
  "shortcutsDialog.selectAllEdges": "Alle Kanten auswählen",
  "shortcutsDialog.measureADistance": "Einen Abstand messen",
  "shortcutsDialog.delete": "Entf",
  "shortcutsDialog.changeWhatTheColoursShow":
    "Bedeutung der Farben wechseln: Linienart, Abweichung oder Überschnitt",
  "shortcutsDialog.showOrHideThisList": "Diese Liste ein- oder ausblenden",
  "shortcutsDialog.wheel": "Mausrad",
  "shortcutsDialog.zoomAtTheCursor": "Am Mauszeiger vergrößern",
  "shortcutsDialog.drag": "Ziehen",
  "shortcutsDialog.click": "Klicken",
  "shortcutsDialog.selectAnEdgeWithShift": "Kante auswählen; mit Umschalt zur Auswahl hinzufügen",
  "shortcutsDialog.shiftDrag": "Umschalt Ziehen",
  "shortcutsDialog.selectTheEdgesInA": "Kanten in einem Rahmen auswählen",
  "shortcutsDialog.altDrag": "Alt Ziehen",
  "shortcutsDialog.selectTheEdgesInALasso": "Kanten im Lasso auswählen",
  "shortcutsDialog.mouse": "Maus",
  "shortcutsDialog.keyboardAndMouseShortcuts": "Tastatur- und Mausbefehle",
  // panels/shared/ShowMore.tsx
  "showMore.showMoreEntriesLeft": "Weitere Einträge anzeigen (noch {left, number})",
  "showMore.showMoreEntries": "Weitere Einträge anzeigen",
  // panels/shared/labels.ts
  "labels.useTheLineTypeThat": "Linienart des Profils verwenden",
  "labels.showTheseEdgesInThe": "Diese Kanten in der Zeichnung zeigen",
  "labels.backToAllDrawings": "Zurück zu allen Zeichnungen",
  // panels/station/DryRunPanel.tsx
  "dryRunPanel.movesAlongTheWholeProgram":
    "Fährt das ganze Programm über dem Karton ab. Nichts wird gesenkt oder eingeschaltet.",
  "dryRunPanel.movesOnceRoundTheSheet":
    "Fährt einmal um den Bogen oder um alle Linien des Programms, über dem Karton.",
  "dryRunPanel.beforeTheStart": "Vor dem Start",
  "dryRunPanel.tryItAboveTheBoard": "Das Programm zuerst über dem Karton ausprobieren",
  "dryRunPanel.speedOfTheDryRun": "Geschwindigkeit des Probelaufs",
  "dryRunPanel.begin": "{kind} starten",
  "dryRunPanel.progress": "Fortschritt: {kind}",
  "dryRunPanel.left": "noch <b>{secondsLeft}</b>",
  "dryRunPanel.progressOfTheRunAbove": "Fortschritt der Fahrt über dem Karton",
  "dryRunPanel.pathOfStationAboveThe":
    "Bahn von Station {number}, {name}. Über dem Karton, nichts wird geschnitten. Der Auftrag wartet weiter auf seinen Start.",
  "dryRunPanel.aboveTheBoardNothingIs":
    "Über dem Karton, nichts wird geschnitten. Der Auftrag wartet weiter auf seinen Start.",
  "dryRunPanel.done": "{run}: beendet. War die Bahn richtig, den Auftrag prüfen und starten.",
  "dryRunPanel.stopped": "{run}: gestoppt. Das Werkzeug ist gehoben.",
  "dryRunPanel.failed": "{run}: fehlgeschlagen.",
  // panels/station/FeedOverride.tsx
  "feedOverride.feed2": "Vorschub {percent, number} %",
  "feedOverride.feedOfTheProgram": "Vorschub <b>{percent} %</b> des Programms",
  // panels/station/HandsClearButton.tsx
  "handsClearButton.countsForSMoreOr":
    "Gilt noch {left, number} s, oder bis sich die Maschine bewegt hat.",
  "handsClearButton.lookThatNobodyReachesInto":
    "Prüfen, dass niemand in die Maschine greift, dann drücken. Gilt 60 s.",
  "handsClearButton.handsClear": "Hände frei",
  // panels/station/JogPad.tsx
  "jogPad.to": "{axis} {travel, number, ::group-off} bis {travel2, number, ::group-off}{axis2}",
  "jogPad.longestMoveOfOneHold": "Längster Weg bei einem Druck (mm, °)",
  "jogPad.free": "Unbegrenzt",
  "jogPad.thereIsNoConnectionTo": "Keine Verbindung zum Server.",
  "jogPad.holdAnArrowToMove":
    "Zum Bewegen einen Pfeil gedrückt halten; beim Loslassen hält die Maschine an.",
  "jogPad.travel": "{reason} Verfahrweg: {machine}",
  "jogPad.isAtTheLimitOf": "{axis} ist am Ende des Verfahrwegs.",
  "jogPad.move": "{label} bewegen",
  "jogPad.stop": "{axis} anhalten",
  "jogPad.whileHeld": "{label}, solange die Taste gedrückt ist",
  "jogPad.whileHeldAtMost":
    "{label}, solange die Taste gedrückt ist, höchstens {limit, number, ::group-off}{axis}",
  // panels/station/StationChecks.tsx
  "stationChecks.checkAtTheTableThen":
    "Am Tisch prüfen, dann starten ({signed, number} von {groups, number})",
  "stationChecks.countsForSMore": "Gilt noch {left, number} s",
  "stationChecks.countsFor60S": "Gilt 60 s",
  // panels/station/StationControls.tsx
  "stationControls.cancelTheJob": "Auftrag abbrechen?",
  "stationControls.theJobHasNotStarted":
    "Der Auftrag hat nicht begonnen. Er verlässt die Warteschlange der Maschine.",
  "stationControls.cancelJob": "Auftrag abbrechen",
  "stationControls.keepJob": "Auftrag behalten",
  "stationControls.stop": "Stopp",
  "stationControls.start": "Start",
  "stationControls.checkAndTickEverythingThat": "Zuerst alles in der Liste prüfen und abhaken.",
  "stationControls.hold": "Halt",
  "stationControls.noJobRuns": "Kein Auftrag läuft.",
  "stationControls.thisMachineCannotBeHeld":
    "Diese Maschine kann von hier nicht angehalten werden. Ihre eigene Bedienung benutzen.",
  "stationControls.hasFinished": "Maschine ist fertig",
  "stationControls.resume": "Weiter",
  "stationControls.thereIsNothingToStop": "Es gibt nichts zu stoppen.",
  "stationControls.jobControls": "Auftrag steuern",
  "stationControls.thereIsNoConnectionTo": "Keine Verbindung zum Server.",
  "stationControls.thisIsNotAnEmergency":
    "<b>Das ist kein Not-Halt.</b> Bei Gefahr den roten Not-Halt-Taster an der Maschine drücken.",
  // panels/station/StationHeader.tsx
  "stationHeader.noConnection": "Keine Verbindung",
  "stationHeader.reported": "Letzte Meldung: {station}",
  "stationHeader.noServer": "Kein Server",
  "stationHeader.connected": "Verbunden",
  "stationHeader.noController": "Keine Steuerung",
  "stationHeader.allDrawings": "Alle Zeichnungen",
  "stationHeader.positionOfTheAxes": "Position der Achsen",
  // panels/station/StationJob.tsx
  "stationJob.job": "Auftrag",
  "stationJob.copies": "{copies, plural, one {# Exemplar} other {# Exemplare}}",
  "stationJob.each": "je {seconds}",
  "stationJob.tryAgain": "Noch einmal versuchen",
  "stationJob.theMachineChecksTheProgram":
    "Die Maschine prüft das Programm noch einmal. Vor dem Start bewegt sich nichts.",
  "stationJob.compileAgain": "Neu berechnen",
  "stationJob.compileTheJobAgain": "Auftrag neu berechnen",
  "stationJob.left": "noch <b>{secondsLeft}</b>",
  "stationJob.copyOf": "Exemplar <b>{copiesDone, number}</b> von {copies, number}",
  "stationJob.progressOfTheJobOn": "Fortschritt des Auftrags auf dem Tisch",
  "stationJob.copiesFinishedTheTableIs":
    "{copies, plural, one {# Exemplar} other {# Exemplare}} fertig. Der Tisch ist frei für den nächsten Auftrag.",
  "stationJob.theJobWasCancelled": "Der Auftrag wurde abgebrochen.",
  "stationJob.queueAgainFromTheStart": "Von Anfang an noch einmal einreihen",
  "stationJob.needsANewSheetThe":
    "Braucht einen neuen Bogen: Das ganze Exemplar wird noch einmal geschnitten.",
  "stationJob.itIsFinished": "Auftrag ist fertig",
  "stationJob.onlyIfAllSheetsAre": "Nur wenn alle Bogen vollständig geschnitten sind.",
  "stationJob.boardIsScrap": "Bogen ist Ausschuss",
  "stationJob.endsTheJobRemoveThe": "Beendet den Auftrag. Zuerst den Bogen wegnehmen.",
  "stationJob.queueTheJobAgainFrom": "Auftrag von Anfang an noch einmal einreihen?",
  "stationJob.theSheetOnTheTable":
    "Der Bogen auf dem Tisch kann dafür nicht verwendet werden. Vor dem Start einen neuen Bogen auflegen.",
  "stationJob.queueAgain": "Noch einmal einreihen",
  "stationJob.doNotQueue": "Nicht einreihen",
  "stationJob.continueThisSheet": "Diesen Bogen fortsetzen",
  "stationJob.thePictureShowsWhereThe":
    "Das Bild zeigt, wo der Kopf angehalten hat: Zeile {line, number} von {lines, number}.",
  "stationJob.thePictureShowsWhereThe2":
    "Das Bild zeigt, wo der Kopf angehalten hat: Zeile {line, number} von {lines, number}, mit {name}.",
  "stationJob.continueThisSheetLeft": "Diesen Bogen fortsetzen, noch {tracks}",
  // panels/station/StationNotices.tsx
  "stationNotices.lookAtTheHeadBefore":
    "Den Kopf ansehen, bevor er sich bewegt. Beim Entsperren, bei der Referenzfahrt und beim Freigeben werden alle Ausgänge ausgeschaltet.",
  "stationNotices.itIsNotKnownWhich":
    "Es ist nicht bekannt, welche Ausgänge an sind: Eine Station kann unten sein.",
  "stationNotices.settingsOfTheController": "Einstellungen der Steuerung",
  "stationNotices.connectionToTheController": "Verbindung zur Steuerung",
  "stationNotices.moreSettingsDiffer": "{rows, number} weitere Einstellungen weichen ab",
  // panels/station/StationOperations.tsx
  "stationOperations.home": "Referenzfahrt",
  "stationOperations.findsTheZeroOfAll":
    "Findet den Nullpunkt aller Achsen. Die Maschine bewegt sich.",
  "stationOperations.park": "Parken",
  "stationOperations.liftsTheToolAndMoves": "Hebt das Werkzeug und fährt den Kopf aus dem Weg.",
  "stationOperations.setXYZeroHere": "Nullpunkt X Y setzen",
  "stationOperations.programsThenBeginAtThis":
    "Programme beginnen dann an dieser Stelle des Tisches.",
  "stationOperations.setTheZeroOfX": "Nullpunkt von X und Y hier setzen?",
  "stationOperations.fromNowOnAllPrograms":
    "Ab jetzt beginnen alle Programme an diesem Punkt. Eine Referenzfahrt hebt das auf.",
  "stationOperations.setZeroHere": "Nullpunkt hier setzen",
  "stationOperations.keepTheZero": "Bisherigen Nullpunkt behalten",
  "stationOperations.unlock": "Entsperren",
  "stationOperations.clearsAnAlarmWithoutHoming":
    "Löscht einen Alarm ohne Referenzfahrt. Die Position kann falsch sein.",
  "stationOperations.thereIsNoConnectionTo":
    "Keine Verbindung zum Server; die Maschine kann von dieser Seite nicht bedient werden.",
  "stationOperations.moveTheMachine": "Maschine bewegen",
  "stationOperations.outputsByHandOnlyAt":
    "Ausgänge von Hand, nur in Ruhe und mit gehobenem Werkzeug",
  "stationOperations.output": "Ausgang {number}",
  "stationOperations.on": "An",
  "stationOperations.off": "Aus",
  "stationOperations.notKnown": "Unbekannt",
  "stationOperations.spindleAt": "{spindle} mit {speed, number}",
  "stationOperations.spindleCounterClockwise": "{spindle}, gegen den Uhrzeigersinn",
  "stationOperations.spindleAtCounterClockwise":
    "{spindle} mit {speed, number}, gegen den Uhrzeigersinn",
  "stationOperations.switchOff": "{name} aus",
  "stationOperations.switchOn": "{name} an",
  "stationOperations.oscillation": "Oszillation",
  "stationOperations.spindle": "Spindel",
  // panels/station/ToolCheckPanel.tsx
  "toolCheckPanel.toolCheck": "Werkzeugprüfung",
  "toolCheckPanel.checkAToolAboveThe": "Werkzeug über dem Karton prüfen",
  "toolCheckPanel.moveAboveThePoint": "{name} über den Punkt fahren",
  "toolCheckPanel.pointOnTheTable": "Punkt auf dem Tisch",
  "toolCheckPanel.tryTheCorrection": "Korrektur ausprobieren",
  "toolCheckPanel.moveAboveThePoint2": "Über den Punkt fahren",
  "toolCheckPanel.thenLowersTheToolAlmost":
    "Senkt dann das Werkzeug fast bis auf den Karton, bei ausgeschalteter Spindel.",
  "toolCheckPanel.lift": "Heben",
  "toolCheckPanel.straightUpAllOutputsGo":
    "Hebt das Werkzeug gerade nach oben und schaltet alle Ausgänge aus.",
  "toolCheckPanel.tool": "Werkzeug",
  "toolCheckPanel.wear": "Verschleiß des Werkzeugs",
  "toolCheckPanel.offset": "Versatz der Station",
  "toolCheckPanel.saveTheOffsetOf": "Versatz von {name} speichern",
  "toolCheckPanel.isTheTipNotAbove":
    "Ist die Spitze nicht über dem Punkt? Versatz korrigieren in Schritten von",
  "toolCheckPanel.less": "{axis} weniger",
  "toolCheckPanel.more": "{axis} mehr",
  "toolCheckPanel.saveTheOffset": "Versatz speichern",
  "toolCheckPanel.toolIsRight": "Werkzeug stimmt ✓",
  "toolCheckPanel.toolIsRight2": "Werkzeug stimmt",
  // panels/station/WornTools.tsx
  "wornTools.otherToolsAreAtThe":
    "{worn, plural, one {Bei einem Werkzeug ist} other {Bei {worn, number} Werkzeugen ist}} die Standzeit abgelaufen",
  "wornTools.workedOfM": "{name}, {used} von {life} m gearbeitet",
  "wornTools.iHavePutANew": "In Station {station} ist ein neues Werkzeug eingesetzt",
  "wornTools.reasonRecorded": "Grund (wird gespeichert)",
  "wornTools.orStateWhyTheOther": "Oder angeben, warum das andere Werkzeug bleibt",
  "wornTools.orStateWhyTheTool": "Oder angeben, warum das Werkzeug bleibt",
  // panels/station/toolText.ts
  "toolText.tipOffsetBesideHeadAxis": "seitlicher Versatz der Spitze zur Kopfachse",
  "toolText.bladeAngle": "Klingenwinkel",
  "toolText.bladeWidth": "Klingenbreite",
  "toolText.tipOffsetBehindHeadAxis": "Spitzenversatz hinter der Kopfachse",
  "toolText.leastRadiusOfABend": "kleinster Biegeradius",
  "toolText.toolRadius": "Werkzeugradius",
  "toolText.bladeTilt": "Klingenneigung",
  "toolText.toolWidth": "Werkzeugbreite",
  "toolText.knife": "Messer",
  "toolText.creaseWheel": "Rillrad",
  "toolText.vCutter": "V-Nut-Messer",
  "toolText.cutter": "Fräser",
  "toolText.laser": "Laser",
  // panels/webhooks/DeliveryList.tsx
  "deliveryList.all": "Alle",
  "deliveryList.deliveries": "Zustellungen",
  "deliveryList.stateOfTheDeliveries": "Zustand der Zustellungen",
  "deliveryList.sendAllFailedDeliveriesAgain": "Alle fehlgeschlagenen noch einmal senden",
  "deliveryList.nothingWasSentInThe": "In den letzten 30 Tagen wurde nichts gesendet.",
  "deliveryList.thereAreNoDeliveriesIn": "Keine Zustellungen in diesem Zustand.",
  "deliveryList.test": "Test",
  "deliveryList.noAttemptIsCompleteYet": "Noch kein Versuch ist abgeschlossen.",
  "deliveryList.emptyResponse": "(leere Antwort)",
  "deliveryList.sendAgain": "Noch einmal senden",
  "deliveryList.webhookId": "webhook-id <code>{id}</code>",
  // panels/webhooks/WebhookCard.tsx
  "webhookCard.sendATest": "Test senden",
  "webhookCard.deliveries": "Zustellungen",
  "webhookCard.edit": "Bearbeiten",
  "webhookCard.replaceTheSecret": "Geheimnis ersetzen",
  "webhookCard.switchOff": "Ausschalten",
  "webhookCard.switchOn": "Einschalten",
  "webhookCard.delete": "Löschen",
  "webhookCard.save": "Speichern",
  "webhookCard.deleteTheWebhook": "Webhook löschen?",
  "webhookCard.noMoreEventsAreSent":
    "An {url} werden keine Ereignisse mehr gesendet, und die Liste der Zustellungen wird gelöscht.",
  "webhookCard.keep": "Behalten",
  "webhookCard.last": "Zuletzt: {eventType}, {created}. {last}",
  "webhookCard.alsoSignedWithTheOld": "Bis {until} auch mit dem alten Geheimnis signiert",
  "webhookCard.test": "Test: {data}",
  // panels/webhooks/WebhookForm.tsx
  "webhookForm.url": "URL",
  "webhookForm.description": "Beschreibung",
  "webhookForm.systemThatReceivesTheEvents": "System, das die Ereignisse empfängt",
  "webhookForm.events": "Ereignisse",
  "webhookForm.allEvents": "Alle Ereignisse",
  "webhookForm.cancel": "Abbrechen",
  // panels/webhooks/WebhookSecret.tsx
  "webhookSecret.secretOfTheWebhook": "Geheimnis des Webhooks",
  "webhookSecret.requestsAreSignedWithBoth":
    "Anfragen sind bis {until} mit beiden Geheimnissen signiert.",
  "webhookSecret.copyTheSecretNowIt":
    "Das Geheimnis jetzt kopieren. Es kann nicht noch einmal gezeigt werden.",
  "webhookSecret.copied": "Kopiert",
  "webhookSecret.copy": "Kopieren",
  "webhookSecret.done": "Fertig",
  "webhookSecret.n24Hours": "24 Stunden",
  "webhookSecret.n1Hour": "1 Stunde",
  "webhookSecret.n7Days": "7 Tage",
  "webhookSecret.n0HoursTheOldSecret": "0 Stunden (das alte Geheimnis ist bekannt geworden)",
  "webhookSecret.replaceTheSecret": "Geheimnis ersetzen?",
  "webhookSecret.forTheChosenTimeRequests":
    "In der gewählten Zeit werden Anfragen mit beiden Geheimnissen signiert. Der Empfänger nimmt sie an, bevor und nachdem dort das neue Geheimnis eingetragen wird. Ältere Geheimnisse werden sofort ungültig.",
  "webhookSecret.alsoSignWithTheOld": "Auch mit dem alten Geheimnis signieren für",
  "webhookSecret.cancel": "Abbrechen",
  "webhookSecret.replaceTheSecret2": "Geheimnis ersetzen",
  // state/accounts/accounts.ts
  "accounts.users": "Benutzer",
  "accounts.designersOperatorsAndAdministrators": "Gestalter, Bediener und Administratoren",
  "accounts.operatorsAndAdministrators": "Bediener und Administratoren",
  "accounts.administrators": "Administratoren",
  "accounts.onlyCanDoThis": "Das dürfen nur {role}. {me}",
  "accounts.thisDeviceIsPairedWith": "Dieses Gerät ({name}) ist nur mit {machines} gekoppelt.",
  "accounts.youAreSignedInAs": "Angemeldet als {name} ({scopes}).",
  "accounts.noScope": "ohne Berechtigung",
  "accounts.viewer": "Betrachter",
  "accounts.designer": "Gestalter",
  "accounts.operator": "Bediener",
  "accounts.admin": "Administrator",
  // state/actions.ts
  "actions.page": "{name}, Seite {page}",
  "actions.theProfileWasChangedElsewhere": "Das Profil wurde anderswo geändert",
  "actions.anotherUserHasChangedThe":
    "Ein anderer Benutzer hat das Profil {title} seit dieser Änderung geändert.",
  "actions.nothingWasUndoneOrRedone":
    "Nichts wurde rückgängig gemacht oder wiederholt. Die Regeln des Profils prüfen.",
  // state/drawing/colours.ts
  "colours.red": "rot",
  "colours.yellow": "gelb",
  "colours.green": "grün",
  "colours.cyan": "cyan",
  "colours.blue": "blau",
  "colours.magenta": "magenta",
  "colours.whiteOrBlack": "weiß oder schwarz",
  "colours.darkGrey": "dunkelgrau",
  "colours.lightGrey": "hellgrau",
  // state/drawing/draft.ts
  "draft.newProfile": "Neues Profil",
  "draft.isNotAColourEnter":
    "{wrong} ist keine Farbe. Eine Zahl von 1 bis 255 oder #rrggbb eingeben.",
  // state/drawing/drawingSync.ts
  "drawingSync.yourChangeWasNotSaved":
    "Änderung nicht gespeichert: Die Zeichnung wurde anderswo geändert",
  "drawingSync.theDrawingWasChangedElsewhere": "Die Zeichnung wurde anderswo geändert",
  "drawingSync.wasChangedByAnotherUser":
    "{name} wurde von einem anderen Benutzer oder in einem anderen Fenster geändert: {before}.",
  "drawingSync.checkTheDrawingThenRepeat":
    "Zeichnung prüfen, dann die Änderung wiederholen, wenn sie noch nötig ist.",
  "drawingSync.yourEarlierChangesCanNo":
    "Frühere Änderungen können nicht mehr rückgängig gemacht werden.",
  // state/drawing/importReport.ts
  "importReport.allObjectsKept": "alle Objekte behalten",
  "importReport.dropped": "{many, number} entfernt",
  "importReport.merged": "{many, number} vereint",
  // state/drawing/inspect.ts
  "inspect.noRuleOfTheProfile":
    "keine Regel des Profils passt, und die Form der Kante verrät die Linienart nicht",
  // state/drawing/learnedLooks.ts
  "learnedLooks.layersWithoutAMeaning": "Layer, deren Name auf keine Linienart deutet",
  "learnedLooks.layer": "Layer {layer}",
  "learnedLooks.colour": "Farbe {colour}",
  "learnedLooks.lineStyle": "Strichart {linetype}",
  "learnedLooks.lineWidthMm": "Strichstärke {lineWidth, number, ::group-off} mm",
  // state/drawing/palette.ts
  "palette.cut": "Schneiden",
  "palette.crease": "Rillen",
  "palette.vGroove": "V-Nut",
  "palette.perforation": "Perforation",
  "palette.halfCut": "Ritzen",
  "palette.combiCutCrease": "Kombi (Schneiden und Rillen)",
  "palette.ignored": "Ignoriert",
  "palette.undecided": "Offen",
  // state/drawing/questions.ts
  "questions.layer": "Layer {layer}",
  "questions.noToolForTheseEdges": "Kein Werkzeug für diese Kanten",
  "questions.edgesWithoutALineType": "Kanten ohne Linienart",
  "questions.colour": "Farbe {colour}",
  "questions.lineStyles": "{count, plural, one {Strichart} other {Stricharten}} {names}",
  "questions.lineWidths": "{count, plural, one {Strichstärke} other {Strichstärken}} {widths}",
  // state/drawing/remoteChanges.ts
  "remoteChanges.itsUnitIsNow": "Einheit jetzt {unit}",
  "remoteChanges.itsProfileIsNow": "Profil jetzt {profile}",
  "remoteChanges.itsEdgesWereReadAgain": "Kanten neu aus der Datei gelesen",
  "remoteChanges.edgesNowHaveAnotherLine":
    "{rows, plural, one {# Kante hat jetzt eine andere Linienart} other {# Kanten haben jetzt eine andere Linienart}}",
  "remoteChanges.lineTypesUnitAndProfile": "Linienarten, Einheit und Profil sind wie vorher",
  "remoteChanges.unitUnknown": "unbekannt",
  // state/drawing/sizes.ts
  "sizes.millimetres": "Millimeter",
  "sizes.centimetres": "Zentimeter",
  "sizes.metres": "Meter",
  "sizes.inches": "Zoll",
  "sizes.feet": "Fuß",
  "sizes.points172Inch": "Punkt (1/72 Zoll)",
  "sizes.pixels196Inch": "Pixel (1/96 Zoll)",
  "sizes.pixels190InchOld": "Pixel (1/90 Zoll, altes Inkscape)",
  // state/drawing/verdictMap.ts
  "verdictMap.lineType": "Linienart",
  "verdictMap.deviationFromDrawing": "Abweichung von der Zeichnung",
  "verdictMap.overcutLength": "Länge des Überschnitts",
  // state/format.ts
  "format.thinnest": "dünnste",
  "format.justNow": "gerade eben",
  "format.minutesAgo": "vor {minutes, number} min",
  "format.hoursAgo": "vor {hours, number} h",
  // state/job/jobs.ts
  "jobs.waitingForProgram": "Wartet auf Programm",
  "jobs.preparingProgram": "Programm wird erstellt",
  "jobs.readyToSend": "Sendebereit",
  "jobs.queued": "In der Warteschlange",
  "jobs.running": "Läuft",
  "jobs.paused": "Angehalten",
  "jobs.finished": "Fertig",
  "jobs.refused": "Abgelehnt",
  "jobs.interrupted": "Unterbrochen",
  "jobs.boardScrapped": "Bogen verworfen",
  "jobs.continuedByAnotherJob": "In anderem Auftrag fortgesetzt",
  "jobs.cancelled": "Abgebrochen",
  "jobs.waitingForOperator": "Wartet auf Bediener",
  "jobs.outOfDate": "Veraltet",
  "jobs.waitingForNewSheet": "Wartet auf neuen Bogen",
  "jobs.hasTheMachineFinished": "Ist die Maschine fertig?",
  "jobs.cancelTheRunningJob": "Laufenden Auftrag abbrechen?",
  "jobs.theMachineStopsLiftsThe":
    "Die Maschine hält an, hebt das Werkzeug und gibt ihre Stationen frei. Der Bogen auf dem Tisch ist wahrscheinlich unbrauchbar.",
  "jobs.cancelJob": "Auftrag abbrechen",
  "jobs.doNotCancel": "Nicht abbrechen",
  "jobs.endThisJobBecauseIts": "Auftrag beenden, weil der Bogen Ausschuss ist?",
  "jobs.removeTheBoardFromThe":
    "Zuerst den Bogen vom Tisch nehmen. Der Auftrag endet, und der Tisch ist frei für den nächsten. Fehlende Exemplare können danach eingereiht werden.",
  "jobs.endJobBoardIsScrap": "Auftrag beenden, Bogen ist Ausschuss",
  "jobs.doNotEndJob": "Auftrag nicht beenden",
  "jobs.markThisJobAsFinished": "Auftrag als fertig melden?",
  "jobs.markTheJobAsFinished":
    "Den Auftrag nur als fertig melden, wenn {copies, plural, one {der Bogen} other {alle # Bogen}} vollständig geschnitten {copies, plural, one {ist} other {sind}}. Der Auftrag endet als fertig, und der Tisch ist frei für den nächsten.",
  "jobs.markAsFinished": "Als fertig melden",
  "jobs.doNotMarkAsFinished": "Nicht als fertig melden",
  // state/job/queue.ts
  "queue.urgent": "Eilig",
  "queue.high": "Hoch",
  "queue.normal": "Normal",
  "queue.low": "Niedrig",
  "queue.onHold": "zurückgestellt",
  "queue.startUnknown": "Start unbekannt",
  "queue.in": "in {startsIn}",
  "queue.next": "als Nächstes",
  // state/job/rest.ts
  "rest.andMore": "{numbers} und {more, number} weitere",
  "rest.and": "{low, number} und {high, number}",
  "rest.tracks": "{most, plural, one {# Bahn} other {# Bahnen}}",
  "rest.tracksBetween": "{least, number} bis {most, plural, one {# Bahn} other {# Bahnen}}",
  "rest.copiesNotMade":
    "{count, plural, one {# Exemplar der Auflage ist} other {# Exemplare der Auflage sind}} nicht gemacht. Zuerst diesen Bogen fortsetzen oder verwerfen, dann die übrigen Exemplare hier einreihen.",
  "rest.copiesNotQueued":
    "{count, plural, one {# Exemplar der Auflage ist} other {# Exemplare der Auflage sind}} weder gemacht noch eingereiht. Jedes braucht einen neuen Bogen.",
  // state/job/stages.ts
  "stages.readingTheDrawing": "Zeichnung wird gelesen",
  "stages.removingDuplicateLinesAndClosing":
    "Doppelte Linien werden entfernt und Lücken geschlossen",
  "stages.assigningToolsToCutsAnd": "Schnitten und Rillen werden Werkzeuge zugeordnet",
  "stages.calculatingToolPaths": "Werkzeugbahnen werden berechnet",
  "stages.choosingTheOrderOfThe": "Reihenfolge der Schnitte wird gewählt",
  "stages.writingTheProgram": "Programm wird geschrieben",
  "stages.checkingTheProgram": "Programm wird geprüft",
  "stages.waitingForTheServerTo": "Warten, bis der Server beginnt",
  "stages.waitingForTheServerTo2": "Warten, bis der Server seinen ersten Start beendet hat",
  "stages.programIsReady": "Programm ist fertig",
  // state/library/definitions.ts
  "definitions.machines": "Maschinen",
  "definitions.boards": "Material",
  "definitions.tools": "Werkzeuge",
  // state/notifications.ts
  "notifications.errorInThisPage": "Fehler in dieser Seite",
  "notifications.reloadThePageAndRepeat":
    "Die Seite neu laden und den letzten Schritt wiederholen.",
  // state/order/sheet.ts
  "sheet.cutToTheOutlineOf": "auf die Außenkontur der Zeichnung zugeschnitten",
  "sheet.mmDrawingMmFromIts":
    "{size, number, ::group-off} × {size2, number, ::group-off} mm, Zeichnung {margin, number, ::group-off} mm vom linken und unteren Rand",
  // state/station/checkGroups.ts
  "checkGroups.boardAndSheet": "Karton und Bogen",
  "checkGroups.tools": "Werkzeuge",
  "checkGroups.tableAndHands": "Tisch und Hände",
  // state/station/checks.ts
  "checks.itHasWorkedM": "Das Werkzeug hat {used} m Linien bearbeitet",
  "checks.itHasWorkedOfM": "Das Werkzeug hat {used} von {life} m seiner Standzeit gearbeitet",
  "checks.itsLifeIsUsedUp": "{worn}: Standzeit abgelaufen, wechseln",
  "checks.changeItSoon": "{worn}: bald wechseln",
  "checks.theDrawingNeeds": "Die Zeichnung braucht {right}",
  // state/station/handsClear.ts
  "handsClear.stateFirstThatHandsAre": "Zuerst bestätigen, dass keine Hände in der Maschine sind.",
  "handsClear.handsClear": "Hände frei",
  "handsClear.takeBackHandsClear": "„Hände frei“ zurücknehmen",
  // state/station/operations.ts
  "operations.start": "Start",
  "operations.theMachineHasNotReacted": "Die Maschine hat seit {prompt, number} s nicht reagiert.",
  "operations.ifItMustStopNow": "Wenn sie sofort anhalten muss, ihren Not-Halt drücken.",
  // state/station/station.ts
  "stationState.controllerNotConnected": "Steuerung nicht verbunden",
  "stationState.atRest": "In Ruhe",
  "stationState.moving": "Bewegt sich",
  "stationState.held": "Angehalten",
  "stationState.movingByHand": "Fährt von Hand",
  "stationState.homing": "Referenzfahrt",
  "stationState.checkMode": "Prüfmodus",
  "stationState.safetyDoorOpen": "Schutztür offen",
  "stationState.alarm": "Alarm",
  "stationState.asleep": "Im Ruhezustand",
  "stationState.waitsForATool": "Wartet auf ein Werkzeug",
  "stationState.busy": "Beschäftigt",
  "stationState.connected": "Verbunden",
  "stationState.dryRun": "Probelauf",
  "stationState.frame": "Rahmen",
  "stationState.toolCheck": "Werkzeugprüfung",
  "stationState.connecting": "Verbindung wird aufgebaut",
  "stationState.machineNotConnected": "Maschine nicht verbunden",
  "stationState.paused": "{title} angehalten",
  "stationState.sAgo": "vor {age, number} s",
  "stationState.theStateOfTheMachine": "Der Zustand der Maschine ist noch nicht bekannt.",
  "stationState.theMachineIsNotConnected": "Die Maschine ist nicht verbunden.",
  "stationState.theControllerOfTheMachine": "Die Steuerung der Maschine ist nicht verbunden.",
  "stationState.aJobIsOnThis": "Auf dieser Maschine ist ein Auftrag. Zuerst stoppen.",
  "stationState.aJobIsHeldOn":
    "Auf dieser Maschine ist ein Auftrag angehalten. Zuerst fortsetzen oder stoppen.",
  "stationState.aJobRunsOnThis":
    "Auf dieser Maschine läuft ein Auftrag. Warten, bis er beendet ist, oder stoppen.",
  "stationState.theControllerOfThisMachine": "Die Steuerung dieser Maschine kann das nicht.",
  "stationState.nothingRuns": "Kein Programm läuft.",
  "stationState.nothingIsHeld": "Kein Programm ist angehalten.",
  "stationState.theMachineRunsAboveThe":
    "Die Maschine macht einen Probelauf über dem Karton. Warten, bis er beendet ist, oder ihn stoppen.",
  "stationState.thereIsNoAlarm": "Es gibt keinen Alarm.",
  "stationState.closeTheSafetyDoorFirst": "Zuerst die Schutztür schließen.",
  "stationState.anAlarmLocksTheMachine":
    "Ein Alarm sperrt die Maschine. Zuerst Referenzfahrt machen oder entsperren.",
  "stationState.theMachineIsNotFree": "Die Maschine ist nicht frei. Zuerst freigeben.",
  "stationState.theMachineMovesWaitUntil": "Die Maschine bewegt sich. Warten, bis sie ruht.",
  "stationState.theToolIsDownRaise":
    "Das Werkzeug ist unten. Zuerst Z auf {machine, number, ::group-off} mm heben.",
  "stationState.sending": "wird gesendet",
  "stationState.acceptedWaitingForTheMachine": "angenommen, wartet auf die Maschine",
  "stationState.done": "erledigt",
  "stationState.refused": "abgelehnt",
  "stationState.expiredNothingWasDone": "abgelaufen, nichts wurde getan",
  // state/station/toolCheck.ts
  "toolCheck.lowerLeftCorner": "Ecke unten links",
  "toolCheck.besideIt": "Neben dem Bogen",
  "toolCheck.upperRightCorner": "Ecke oben rechts",
  "toolCheck.ifTheOffsetOfA":
    "Wurde der Versatz einer Station korrigiert, zuerst die neue Werkzeugtabelle nach LinuxCNC kopieren.",
  "toolCheck.forTheNewestVersionOf":
    "Berechnet das Programm für die neueste Version von Maschine und Material neu.",
  "toolCheck.theMachineCannotBeChanged": "Die Maschine kann nicht geändert werden",
  "toolCheck.belongsToTheLibraryAnd":
    "{title} gehört zur Bibliothek und kann nicht geändert werden.",
  "toolCheck.copyItUnderAName":
    "Unter eigenem Namen in die Bibliothek kopieren, das Gateway auf die Kopie umstellen und noch einmal prüfen.",
  "toolCheck.datumOfStationAfterA": "Versatz von Station {station} nach einer Werkzeugprüfung",
  // state/station/wayOut.ts
  "wayOut.home": "Referenzfahrt",
  "wayOut.findsTheZeroOfAll": "Findet den Nullpunkt aller Achsen. Die Maschine bewegt sich.",
  "wayOut.unlock": "Entsperren",
  "wayOut.clearsTheAlarmWithoutHoming":
    "Löscht den Alarm ohne Referenzfahrt. Die Position kann falsch sein.",
  "wayOut.switchesTheMachineOnIt":
    "Schaltet die Maschine ein. Danach kann eine Referenzfahrt nötig sein.",
  "wayOut.release": "Freigeben",
  "wayOut.discardsWhatTheMachineHolds":
    "Verwirft den Rest des angehaltenen Programms. Keine Achse bewegt sich; die Stationen werden gehoben.",
  "wayOut.alarm": "Alarm",
  "wayOut.theJobDoesNotMove": "Der Auftrag kann nicht weiterlaufen",
  "wayOut.theMachineTakesNoJob": "Die Maschine kann keinen Auftrag annehmen",
  "wayOut.thereIsNoJobFor": "Es gibt keinen Auftrag für diese Maschine.",
  "wayOut.theMachineRunsAboveThe":
    "Die Maschine macht einen Probelauf über dem Karton. Warten, bis er beendet ist, oder ihn stoppen.",
  "wayOut.noJobWaitsForIts": "Kein Auftrag wartet auf seinen Start.",
  "wayOut.noJobIsHeld": "Kein Auftrag ist angehalten.",
  "wayOut.closeTheSafetyDoorFirst": "Zuerst die Schutztür schließen.",
  // state/webhooks/webhooks.ts
  "webhookTexts.jobReceived": "Auftrag erhalten",
  "webhookTexts.jobCompiling": "Auftrag wird berechnet",
  "webhookTexts.jobReady": "Auftrag bereit",
  "webhookTexts.jobQueued": "Auftrag in der Warteschlange",
  "webhookTexts.jobRunning": "Auftrag läuft",
  "webhookTexts.jobHeld": "Auftrag angehalten",
  "webhookTexts.jobFinished": "Auftrag fertig",
  "webhookTexts.jobRefused": "Auftrag abgelehnt",
  "webhookTexts.jobInterrupted": "Auftrag unterbrochen",
  "webhookTexts.boardScrapped": "Bogen verworfen",
  "webhookTexts.jobContinuedByAnotherJob": "Auftrag in anderem fortgesetzt",
  "webhookTexts.jobCancelled": "Auftrag abgebrochen",
  "webhookTexts.otherChangeOfAJob": "Andere Änderung eines Auftrags",
  "webhookTexts.drawingUploaded": "Zeichnung hochgeladen",
  "webhookTexts.drawingChanged": "Zeichnung geändert",
  "webhookTexts.drawingDeleted": "Zeichnung gelöscht",
  "webhookTexts.waiting": "Wartet",
  "webhookTexts.delivered": "Zugestellt",
  "webhookTexts.failed": "Fehlgeschlagen",
  "webhookTexts.allEvents": "Alle Ereignisse",
  "webhookTexts.ms": "{seconds, number} ms",
  "webhookTexts.noAnswer": "Keine Antwort",
  "webhookTexts.status": "Status {status}",
  "webhookTexts.notSentYet": "Noch nicht gesendet",
  "webhookTexts.after": "{attempt} nach {seconds}",
  "webhookTexts.delivered2": "Zugestellt: {result}",
  "webhookTexts.failed2": "Fehlgeschlagen: {result}",
  "webhookTexts.nextAttempt": "{result}; nächster Versuch {next}",
  "webhookTexts.switchedOff": "Ausgeschaltet",
  "webhookTexts.pausedUntilAfterFailedAttempts":
    "Pause bis {paused} nach {failures, plural, one {# Fehlversuch} other {# Fehlversuchen}}",
  "webhookTexts.theLastAttemptFailed": "Der letzte Versuch schlug fehl",
  "webhookTexts.failedAttempts": "{failures, plural, one {# Fehlversuch} other {# Fehlversuche}}",
  "webhookTexts.nothingSentYet": "Noch nichts gesendet",
  "webhookTexts.working": "Funktioniert",
  "webhookTexts.s": "{seconds} s",
  // app: places and steps
  "app.thereIsNoMachine": "Es gibt noch keine Maschine. Legen Sie eine in der Bibliothek an.",
  "shell.messages": "Meldungen",
  "shell.theServerDoesNotRespond":
    "Der Server antwortet nicht. Was Sie sehen, kann veraltet sein; Änderungen werden nicht gespeichert.",
  // panels/drafting/AreaBar.tsx
  "areaBar.selectByArea": "Kanten in einer Fläche auswählen",
  "areaBar.dragABoxAround":
    "Einen Rahmen um die Kanten ziehen. Zwei Finger verschieben die Ansicht.",
  "areaBar.drawALineAround":
    "Eine Linie um die Kanten zeichnen. Zwei Finger verschieben die Ansicht.",
  "areaBar.whatTheEdgesInTheAreaDo": "Was mit den Kanten in der Fläche geschieht",
  "areaBar.new": "Neu",
  "areaBar.add": "Dazu",
  "areaBar.remove": "Weg",
  // panels/drawing/SelectMenu.tsx
  "selectMenu.selectEdgesBy": "Kanten auswählen nach…",
  "selectMenu.lineType": "Linienart",
  "selectMenu.any": "Beliebig",
  "selectMenu.lengthFrom": "Länge von",
  "selectMenu.lengthTo": "bis",
  "selectMenu.whatTheyDo": "Was mit ihnen geschieht",
  "selectMenu.edges": "{count, plural, one {# Kante} other {# Kanten}}",
  "selectMenu.select": "Auswählen",
  // panels/drafting/DimensionOverlay.tsx
  "dimensions.dimensions": "Maße",
  "dimensions.removeTheDimension": "Das Maß {text} entfernen",
  // state/commands/keys.ts
  "keys.ctrl": "Strg",
  "keys.shift": "Umschalt",
  "keys.enter": "Eingabe",
  // state/commands
  "commands.steps": "Schritte",
  "commands.questions": "Fragen",
  "commands.select": "Auswahl von Kanten",
  "commands.types": "Linienart der ausgewählten Kanten",
  "commands.tools": "Werkzeuge",
  "commands.view": "Ansicht",
  "commands.page": "Seite",
  "commands.goToStep": "Zum Schritt {step}",
  "commands.mainAction": "Zur Haupttaste des Schritts",
  "commands.acceptLikely": "Die wahrscheinlichste Linienart annehmen",
  "commands.selectSimilar": "Ähnliche Kanten auswählen: Linienart, Layer und Länge",
  "commands.selectConnected": "Den zusammenhängenden Zug auswählen",
  "commands.selectSameType": "Kanten derselben Linienart auswählen",
  "commands.selectSameLayer": "Kanten desselben Layers auswählen",
  "commands.setType": "Linienart auf {type} setzen",
  "commands.useProfileType": "Linienart des Profils verwenden",
  "commands.selectByBox": "Kanten in einem Rahmen auswählen",
  "commands.selectByLasso": "Kanten mit dem Lasso auswählen",
  "commands.zoomIn": "Vergrößern",
  "commands.zoomOut": "Verkleinern",
  "commands.panLeft": "Ansicht nach links verschieben",
  "commands.panRight": "Ansicht nach rechts verschieben",
  "commands.panUp": "Ansicht nach oben verschieben",
  "commands.panDown": "Ansicht nach unten verschieben",
  "commands.dimensions": "Maße ein- oder ausblenden",
  "commands.edgeList": "Kantenliste ein- oder ausblenden",
  "commands.panel": "Seitenleiste ein- oder ausblenden",
  // panels/commands/Palette.tsx
  "palette.commands": "Suche",
  "palette.openKey": "Befehle, Orte und Zeichnungen (Strg K)",
  "palette.search": "Befehl, Ort oder Name einer Zeichnung",
  "palette.drawings": "Zeichnungen",
  "palette.nothingFound": "Nichts gefunden",
  // panels/drawing/EdgeList.tsx
  "edgeList.whatThePanelShows": "Was die Seitenleiste zeigt",
  "edgeList.lineTypesAndLayers": "Linienarten",
  "edgeList.edgeList": "Kantenliste",
  "edgeList.number": "Nr.",
  "edgeList.length": "Länge",
  "edgeList.layer": "Layer",
  "edgeList.state": "Zustand",
  "edgeList.sortBy": "Sortieren nach {column}",
  "edgeList.layerOrNumber": "Layer oder Nummer",
  "edgeList.allLineTypes": "Alle Linienarten",
  "edgeList.allStates": "Alle Zustände",
  "edgeList.listedAndSelected":
    "{listed, plural, one {# Kante} other {# Kanten}}, {selected, number} ausgewählt",
  "edgeList.selectTheListed": "Diese auswählen",
  // panels/drawing/edgeStateTitles.ts
  "edgeState.undecided": "offen",
  "edgeState.byHand": "von Hand",
  "edgeState.merged": "vereinigt",
  "edgeState.dropped": "entfällt",
  "edgeState.kept": "gezeichnet",
  // panels/drawing/SettledQuestions.tsx
  "settledQuestions.unit": "Einheit",
  "settledQuestions.answered": "{count, plural, one {# Frage} other {# Fragen}} beantwortet",
  "settledQuestions.allAnswered": "Alle Fragen sind beantwortet",
  "rail.places": "Bereiche",
  "rail.work": "Arbeit",
  "rail.drawing": "Zeichnung",
  "rail.openADrawingFirst": "Öffnen Sie zuerst unter Arbeit eine Zeichnung",
  "rail.machines": "Maschinen",
  "rail.station": "Station",
  "rail.library": "Bibliothek",
  "rail.history": "Verlauf",
  "rail.settings": "Optionen",
  "drawingPage.choicesOfThisStep": "Angaben zu diesem Schritt",
  "zoomControls.undoAndZoom": "Rückgängig und Zoom",
  "stepBar.lines": "Linien",
  "stepBar.sheet": "Bogen",
  "stepBar.process": "Verfahren",
  "stepBar.check": "Prüfung",
  "stepBar.done": "erledigt",
  "stepBar.needsYou": "wartet auf Sie",
  "stepBar.notYet": "noch nicht",
  "stepBar.working": "in Arbeit",
  "stepBar.warning": "Warnung",
  "stepBar.questions": "{count, plural, one {# Frage} other {# Fragen}}",
  "stepBar.stepsOfThisDrawing": "Schritte dieser Zeichnung",
  "mainAction.answerQuestions": "{questions, plural, one {# Frage} other {# Fragen}} beantworten",
  "mainAction.toTheStation": "Zur Station",
  "mainAction.chooseTheBoard": "Material wählen",
  "sheetStep.boardAndMachine": "Material und Maschine",
  "sheetStep.changeTheSheet": "Den Bogen und seine Zeichnungen ändern",
  "sheetStep.sheetAndCopies": "Bogen und Stückzahl",
  "processStep.howItIsMade": "Wie gefertigt wird",
  "processStep.singleEdges": "Einzelne Kanten",
  "processStep.selectEdgesInTheDrawing":
    "Wählen Sie Kanten in der Zeichnung aus, um ihnen eine eigene Tiefe, einen eigenen Vorschub oder Startpunkt zu geben.",
  "processStep.order": "Auftrag",
  "processStep.toolsOf": "Werkzeuge von {title}",
  "processStep.workOrder": "Reihenfolge der Arbeit",
  "workOrder.noProgramYet":
    "Erstellen Sie einmal das Programm: Dann stehen hier seine Züge in der Reihenfolge der Arbeit, und Sie können sie verschieben.",
  "workOrder.shortest":
    "Die Züge stehen in der Reihenfolge des kürzesten Wegs. Ziehen Sie sie oder verschieben Sie sie mit den Pfeilen.",
  "workOrder.byHand": "Das nächste Programm macht die Züge in dieser Reihenfolge.",
  "workOrder.tooMany":
    "{n} Züge sind zu viele, um sie von Hand zu ordnen; höchstens {most} werden aufgelistet.",
  "workOrder.byTheShortestWay": "Auf dem kürzesten Weg",
  "workOrder.track": "{type}, {n, plural, one {Kante {edge}} other {# Kanten ab Kante {edge}}}",
  "workOrder.edgesAndTool":
    "{n, plural, one {Kante {edge}} other {# Kanten ab {edge}}} · Werkzeug {station}",
  "workOrder.creasesFirst":
    "zuerst kommen Rillen, solange der Karton fest liegt, dann V-Nuten, Ritzungen und Perforationen, zuletzt Schnitte.",
  "workOrder.oneToolAfterTheOther":
    "jedes Werkzeug macht seine ganze Arbeit, bevor das nächste genommen wird.",
  "workOrder.piecesFirst":
    "Löcher, Schlitze und innere Konturen werden vor Umrissen geschnitten, damit kein Werkzeug auf losem Karton arbeitet.",
  "workOrder.insideFirst":
    "was in einer Kontur liegt, wird geschnitten, solange der Bogen es hält.",
  "workOrder.comesBefore": "„{first}“ kommt vor „{second}“: {why}",
  "workOrder.howToMove":
    "Leertaste hebt die Zeile an, Pfeiltasten verschieben sie, noch einmal Leertaste setzt sie ab; Escape bricht ab.",
  "workOrder.view": "Wie die Reihenfolge aufgelistet ist",
  "workOrder.byBlanks": "Nach Zuschnitten",
  "workOrder.inOneList": "In einer Liste",
  "workOrder.aboutBlanks":
    "Die Zuschnitte stehen in der Folge, in der sie fertig werden. Ein verschobener Zuschnitt kommt in jedem Arbeitsgang früher oder später; die Arbeitsgänge behalten ihre Reihenfolge.",
  "workOrder.blank": "Zuschnitt {number}",
  "workOrder.besideBlanks": "Neben den Zuschnitten",
  "workOrder.layer": "{type}, Arbeitsgang {place} von {count}",
  "workOrder.contentsOf": "Inhalt: {name}",
  "workOrder.tracks": "{n, plural, one {# Zug} other {# Züge}}",
  "workOrder.tracksInLayers":
    "{tracks, plural, one {# Zug} other {# Züge}} in {layers, plural, one {# Arbeitsgang} other {# Arbeitsgängen}}",
  "workOrder.drag": "{name} verschieben, jetzt an Platz {place}",
  "workOrder.moveUp": "Früher: {name}",
  "workOrder.moveDown": "Später: {name}",
  "workOrder.atPlace": "{name}: Platz {place} von {count}",
  "workOrder.tracksInOrder":
    "{n, plural, one {# Zug hat} other {# Züge haben}} einen eigenen Platz",
  "lastTime.asLastTime": "Wie beim letzten Mal",
  "lastTime.undo": "Rückgängig",
  "lastTime.from": "Aus dem Auftrag {order} vom {when}.",
  "lastTime.sameAs": "Die Angaben sind die des letzten Auftrags. {from}",
  "lastTime.ofCustomer":
    "Es ist der neueste Auftrag von {customer} auf diesem Material und dieser Maschine.",
  "lastTime.anyCustomer":
    "Es ist der neueste Auftrag auf diesem Material und dieser Maschine; ein Kunde ist nicht angegeben.",
  "bridges.bridges": "Haltestege",
  "bridges.onlyThese": "Ein Umriss mit einem von Hand gesetzten Steg hat nur solche Stege.",
  "bridges.byTheBoard": "Ohne von Hand gesetzten Steg haben Umrisse die des Materials.",
  "bridges.requiredByTheBoard":
    "Das Material hat Stege von {width} mm, höchstens {spacing} mm voneinander. Ein Umriss mit einem von Hand gesetzten Steg hat nur solche.",
  "bridges.noneByTheBoard":
    "Das Material hat keine Stege. Setzen Sie welche, wo ein Teil gehalten werden muss.",
  "bridges.clickTheOutline":
    "Klicken Sie in der Zeichnung auf die Stellen am Umriss eines Teils, an denen Karton stehen bleiben soll.",
  "bridges.widthOfTheNext": "Breite",
  "bridges.place": "Stege setzen",
  "bridges.finish": "Stege fertig gesetzt",
  "bridges.at": "Kante {edge}, {place} mm ab ihrem Anfang",
  "bridges.widthOf": "Breite des Stegs: {place}",
  "bridges.placed": "{n, plural, one {# Steg} other {# Stege}} von Hand gesetzt",
  "checkStep.thereIsNoProgramYet":
    "Es gibt noch kein Programm. Erstellen Sie es: Dann zeigt dieser Schritt, ob es Ihre Zeichnung fertigt.",
  "jobsOfDrawing.otherJobsOfThisDrawing": "Andere Aufträge dieser Zeichnung",
  "tablePicture.table": "Tisch von {title} mit dem Kopf und der Arbeit des laufenden Auftrags",
  "machinesPage.allMachines": "Alle Maschinen",
  "machinesPage.machines": "Maschinen",
  "machineCard.openStation": "Station öffnen",
  "machineCard.toolsAndConnection": "Werkzeuge und Anschluss",
  "machineCard.noSheetOnTheTable": "Kein Auftrag liegt auf dem Tisch.",
  "machineCard.onTheTable": "Auf dem Tisch: {board} für {name}",
  "settingsPage.settings": "Optionen",
  "settingsPage.asTheSystem": "Wie das System",
  "settingsPage.light": "Hell",
  "settingsPage.dark": "Dunkel",
  "settingsPage.colourScheme": "Farbschema",
  "settingsPage.nameOfTheOperator": "Name der Person an diesem Gerät",
  "settingsPage.otherSystems": "Andere Systeme",
  "settingsPage.descriptionOfTheApi": "Beschreibung der Schnittstelle",
  "settingsPage.help": "Hilfe",
  "workPage.work": "Arbeit",
  "workPage.nothingMeetsTheseConditions": "Keine Zeichnung erfüllt diese Bedingungen.",
  "workFilters.allStates": "Alle Zustände",
  "workFilters.toPrepare": "Vorzubereiten",
  "workFilters.readyToSend": "Bereit zum Senden",
  "workFilters.atTheMachine": "An der Maschine",
  "workFilters.ended": "Beendet",
  "workFilters.newestFirst": "Neueste zuerst",
  "workFilters.byDueTime": "Nach Termin",
  "workFilters.byCustomer": "Nach Kunde",
  "workFilters.byName": "Nach Name",
  "workFilters.byBoard": "Nach Material",
  "workFilters.byMachine": "Nach Maschine",
  "workFilters.byState": "Nach Zustand",
  "workFilters.byTime": "Nach Maschinenzeit",
  "workFilters.search": "Name, Kunde, Auftrag suchen",
  "workFilters.state": "Zustand",
  "workFilters.machine": "Maschine",
  "workFilters.allMachines": "Alle Maschinen",
  "workFilters.order": "Reihenfolge der Tabelle",
  "workTable.drawing": "Zeichnung",
  "workTable.customer": "Kunde",
  "workTable.due": "Termin",
  "workTable.board": "Material",
  "workTable.machine": "Maschine",
  "workTable.state": "Zustand",
  "workTable.time": "Maschinenzeit",
  "workTable.nextAction": "Als Nächstes",
  "workTable.delete": "Löschen",
  "workTable.sheet": "Bogen",
  "workTable.sameFile": "{others, plural, one {# weitere} other {# weitere}} mit derselben Datei",
  "workTable.deleteThisDrawing": "Diese Zeichnung löschen?",
  "workTable.isDeletedForEver":
    "{name} wird mit allen Linienarten, die Sie gesetzt haben, gelöscht. Das lässt sich nicht rückgängig machen.",
  "workTable.deleteDrawing": "Zeichnung löschen",
  "workTable.keepIt": "Behalten",
  "workTable.deleteNamed": "{name} löschen",
  "workTable.aJobWasMadeFromIt":
    "Aus dieser Zeichnung wurde ein Auftrag gefertigt, darum wird sie behalten",
  "orders.answerQuestions": "{questions, plural, one {# Frage} other {# Fragen}}",
  "orders.prepare": "Vorbereiten",
  "orders.beingPrepared": "Wird erstellt",
  "orders.send": "Senden",
  "orders.lookAtTheRefusal": "Grund ansehen",
  "orders.atTheMachine": "An der Maschine",
  "orders.inTheQueue": "In der Warteschlange",
  "orders.prepareAgain": "Erneut vorbereiten",
  "welcome.orTryASample": "Oder probieren Sie ein Beispiel:",
  "welcome.tuckEndCarton": "Faltschachtel",
  "welcome.corrugatedTray": "Wellpappe-Tray",
  "welcome.rigidBox": "Feinkartonage, V-Nuten",
  "questionsPanel.previous": "Vorige Frage",
  "questionsPanel.next": "Nächste Frage",
  "questionsPanel.previousKey": "Vorherige Frage (Taste ,)",
  "questionsPanel.nextKey": "Nächste Frage (Taste .)",
  "questionsPanel.questionOf": "Frage {at} von {all}",
  "questionsPanel.allInATable": "Alle Fragen in einer Tabelle",
  "showCompensation.showTheCompensation": "Korrektur zeigen",
  "verdictCard.cutsYourDrawing": "Fertigt Ihre Zeichnung auf {deviation} genau in {seconds}",
  "verdictCard.cutsYourDrawingExcept":
    "Fertigt Ihre Zeichnung auf {deviation} genau in {seconds}, bis auf {exceptions, plural, one {# zugelassene Abweichung} other {# zugelassene Abweichungen}}",
  "verdictCard.details": "Einzelheiten",
  "verdictPlaces.overcut":
    "bis zu {length} Überschnitt an {places, plural, one {# Stelle} other {# Stellen}}",
  "verdictPlaces.allowed": "{length} zulässig",
  "verdictPlaces.leftOut":
    "{length} bleiben an den Enden von {places, plural, one {# Linie} other {# Linien}} stehen, wie geplant",
  "verdictPlaces.uncut":
    "Bis zu {length} nicht geschnitten an {places, plural, one {# Stelle} other {# Stellen}}",
  "verdictPlaces.eachClickShowsTheNext": "Jeder Klick zeigt die nächste Stelle",
  "documentPanel.file": "Datei und Regeln",
  // panels/job/HeadFigures.tsx
  "headFigures.heading": "Richtung",
  "headFigures.lean": "Neigung",
  // panels/job/ProgramLines.tsx
  "programLines.programLines": "Programmzeilen",
  "programLines.lines": "{lines, plural, one {# Zeile} other {# Zeilen}}",
  "programLines.linesOfTheProgram": "Zeilen des Programms",
  "programLines.goToLine": "Zeile (1 bis {lines, number})",
  "programLines.eachLineShowsItsPlace": "Eine Zeile stellt Regler und Werkzeug an ihre Stelle.",
  // panels/job/SectionPanel.tsx
  "sectionPanel.sectionAtThisPlace": "Schnittbild des Materials",
  "sectionPanel.sectionToScale": "Maßstäbliches Schnittbild quer zur Linie: {tool}",
  "sectionPanel.chooseAnEdge":
    "Linie auf der Zeichenfläche wählen oder den Regler bewegen: hier erscheint das Schnittbild.",
  "sectionPanel.noToolMakesTheEdge": "Kein Werkzeug dieses Programms bearbeitet Kante {edge}.",
  "sectionPanel.madeWithEdge": "Kante {edge} wird zusammen mit Kante {other} bearbeitet.",
  "sectionPanel.edgeByTool": "Kante {edge} · {tool}",
  "sectionPanel.measuresOf": "Maße von Kante {edge}, {tool}",
  "sectionPanel.caliper": "Materialdicke",
  "sectionPanel.depth": "Tiefe unter der Oberseite",
  "sectionPanel.beyond": "Schnitt in die Unterlage",
  "sectionPanel.web": "Steg unter der Nut",
  "sectionPanel.base": "Material unter der Rillung",
  "sectionPanel.left": "Darunter nicht geschnitten",
  "sectionPanel.topWidth": "Breite an der Oberseite",
  "sectionPanel.slotWidth": "Breite der Fräsnut",
  "sectionPanel.rimWidth": "Breite des Rillrads",
  "sectionPanel.foldAngle": "Faltwinkel bei geschlossener Nut",
  "sectionPanel.requiredFold": "Faltwinkel laut Materialdatei",
  "sectionPanel.flankAngle": "Flanke zur Senkrechten",
  "sectionPanel.passes": "Durchgänge verschiedener Tiefe",
  "sectionPanel.wheelRadius": "Radius des Rillrads",
  "sectionPanel.contactLength": "Kontakt entlang der Linie",
  "sectionPanel.bladeWidth": "Breite der Klinge",
  "sectionPanel.bladeAngle": "Schräge der Klinge",
  "sectionPanel.bladeLead": "Vorlauf an der Oberseite",
  "sectionPanel.deviation": "Abweichung von der Zeichnung",
  "sectionPanel.flank": "Abweichung der Flanken",
  "sectionPanel.overcut": "Überschnitt an den Enden",
  "sectionPanel.topOvercut": "Überschnitt an der Oberseite",
  "sectionPanel.bottomUncut": "Ungeschnitten an der Unterseite",
  "sectionPanel.uncut": "Nicht geschnitten",
  "sectionPanel.setback": "An den Enden ausgelassen, wie geplant",
  "sectionPanel.slitLength": "Schlitz in Werkzeugbreite",
  // app/FoldCanvas.tsx
  "foldCanvas.foldedBoard":
    "Der gefaltete Zuschnitt in 3D, {panels, number} Felder. Pfeiltasten drehen ihn, + und − zoomen, 0 zeigt alles.",
  // app/FoldPage.tsx
  "foldPage.folding": "Die Zeichnung wird gefaltet",
  "foldPage.foldedBy": "Gefaltet um (Prozent)",
  "foldPage.folds": "Faltungen",
  "foldPage.folded": "{title}, gefaltet",
  "foldPage.backToTheDrawing": "Zurück zur Zeichnung",
  "foldPage.board": "Material",
  "foldPage.sideUp": "Oben liegende Seite des Kartons",
  "foldPage.outside": "Außen: Rillungen falten nach unten",
  "foldPage.inside": "Innen: Rillungen falten nach oben",
  "foldPage.opening": "Öffnungswinkel der V-Nuten",
  "foldPage.showAll": "Alles zeigen",
  "foldPage.savePicture": "Bild speichern (PNG)",
  "foldPage.saveGltf": "3D-Modell speichern (glTF)",
  "foldPage.faults": "Fehler",
  "foldPage.noBlank":
    "Die Schnitte der Zeichnung umschließen keinen Zuschnitt, der gefaltet werden kann.",
  // panels/fold/FoldFindings.tsx
  "foldFindings.noFaults":
    "Kein Feld stößt an, keine Klappe ist zu lang, und alle Nuten schließen.",
  // panels/fold/FoldList.tsx
  "foldList.foldBetween": "Faltung {fold, number}: Feld {child, number} an Feld {parent, number}",
  "foldList.closesHere": "Schließt hier: andere Faltungen verbinden diese Felder",
  "foldList.notStraight": "Nicht gerade: bleibt flach",
  "foldList.groove": "V-Nut, die bei {opening, number}° schließt",
  "foldList.crease": "Rillung",
  // panels/layout
  "layoutEditor.layOut": "Auf einem Bogen anordnen",
  "layoutEditor.backToDrawings": "Zurück zu den Zeichnungen",
  "layoutEditor.theSheet":
    "Der Bogen. Pfeiltasten bewegen das Gewählte (Umschalt: 10 mm, Alt: 0,1 mm), R dreht, M spiegelt, Entf entfernt.",
  "layoutEditor.xMm": "X (mm)",
  "layoutEditor.yMm": "Y (mm)",
  "layoutEditor.turn": "Drehung (°)",
  "layoutEditor.columns": "Spalten",
  "layoutEditor.rows": "Zeilen",
  "layoutEditor.gapX": "Abstand X (mm)",
  "layoutEditor.gapY": "Abstand Y (mm)",
  "layoutEditor.placedDrawings": "Zeichnungen auf dem Bogen",
  "layoutEditor.collides": "Kollision",
  "layoutEditor.turnBy90": "{name} um 90° drehen",
  "layoutEditor.duplicate": "{name} noch einmal platzieren",
  "layoutEditor.remove": "{name} entfernen",
  "layoutEditor.mirror": "Spiegeln",
  "layoutEditor.fillTheSheet": "Bogen mit Zeilen und Spalten füllen",
  "layoutEditor.copiesOf": "Exemplare von {name}",
  "layoutEditor.gapMm": "Abstand (mm)",
  "layoutEditor.marginMm": "Rand (mm)",
  "layoutEditor.timeS": "Zeit (s)",
  "layoutEditor.nest": "Schachteln",
  "layoutEditor.nesting": "Schachtelung",
  "layoutEditor.stopAndKeep": "Anhalten und behalten",
  "layoutEditor.bestSoFar": "Nutzung {use} %, mit Rechtecken {rectangles} %; Bogen: {sheets}",
  "layoutEditor.boardUse": "Nutzung {use} %; Exemplare: {count}",
  "layoutEditor.undo": "Rückgängig",
  "layoutEditor.redo": "Wiederholen",
  "layoutEditor.save": "Speichern",
  "layoutEditor.orderThisSheet": "Diesen Bogen bestellen",
  "layoutEditor.collisions": "Exemplare mit Kollision: {count}",
  "layoutEditor.sheetAndDrawings": "Bogen und Zeichnungen",
  "layoutEditor.widthMm": "Breite (mm)",
  "layoutEditor.heightMm": "Höhe (mm)",
  "layoutEditor.grain": "Faserrichtung",
  "layoutEditor.noGrain": "keine",
  "layoutEditor.grainAlongX": "längs X",
  "layoutEditor.grainAlongY": "längs Y",
  "layoutEditor.align": "Ausrichten",
  "layoutEditor.left": "Links",
  "layoutEditor.right": "Rechts",
  "layoutEditor.below": "Unten",
  "layoutEditor.above": "Oben",
  "layoutEditor.centreX": "Mitte X",
  "layoutEditor.centreY": "Mitte Y",
  "layoutEditor.addADrawing": "Zeichnung hinzufügen",
  "layoutEditor.board": "Material",
  "layoutEditor.size": "{width} × {height} mm",
  "layoutEditor.stock": "Bogen im Vorrat",
  "layoutEditor.stockCount":
    "{count, plural, =0 {Keine Bogen im Vorrat} one {# Größe im Vorrat} other {# Größen im Vorrat}}",
  "layoutEditor.addThisSize": "Diesen Bogen in den Vorrat aufnehmen",
  "layoutEditor.keepRemnant": "Rest von {size} behalten",
  "layoutEditor.remnantOf": "Rest von {name}",
  "layoutEditor.useUp": "Einen Bogen von {size} aus dem Vorrat nehmen",
  "layoutEditor.fromStock": "Zuerst Bogen aus dem Vorrat verwenden",
  "layoutEditor.useHoles": "Kleine Zuschnitte in Löcher von großen",
  "layoutEditor.inHoles":
    "{n, plural, one {# Exemplar liegt} other {# Exemplare liegen}} in Löchern.",
} as const satisfies Translation;
