/** English texts of the page: the source of the other languages. */

import { DECLARED_TEXTS } from "./declared.gen";

export const en = {
  ...DECLARED_TEXTS,
  // api/columns.ts
  "columns.theServerSentDataOf":
    "The server sent data of an unknown format (“{magic}” instead of “{magic2}”). Reload the page.",
  "columns.theDataFromTheServer":
    "The data from the server is incomplete: its header should have {size, number} bytes. Reload the page.",
  "columns.theDataFromTheServer2":
    "The data from the server is incomplete: column {name} should have {count, number} values ({dtype}). Reload the page.",
  "columns.theDataFromTheServer3":
    "The data from the server lacks the column {name}. Reload the page.",
  // api/errors.ts
  "errors.noResponseFromTheServer": "No response from the server",
  "errors.theKnifetipServerDoesNot": "The knifetip server does not respond.",
  "errors.checkThatTheServerIs":
    "Check that the server is running and that this computer can reach it. Then try again.",
  "errors.error": "Error {status}",
  "errors.theKnifetipServerAnsweredWith":
    "The knifetip server answered with error {status} ({title}).",
  "errors.theKnifetipServerAnsweredWith2": "The knifetip server answered with error {status}.",
  "errors.tryAgainIfTheError":
    "Try again. If the error persists, look for its cause in the log of the server.",
  // app/App.tsx
  "app.jobQueueAndMachine": "Job, queue and machine",
  "app.drawingsLineTypesAndImport": "Drawings, line types and import",
  "app.thereIsNoSuchPage": "There is no such page",
  // app/DrawingError.tsx
  "drawingError.thisDrawingCannotBeOpened": "This drawing cannot be opened",
  // app/DropZone.tsx
  "dropZone.dropDrawingFilesHereTo": "Drop drawing files here to open them",
  // app/LibraryPage.tsx
  "libraryPage.importedFrom": "imported from {name}",
  "libraryPage.machinesBoardsAndTools": "Machines, boards and tools",
  "libraryPage.thereIsNo":
    "There is no {shelf, select, machines {machine} boards {board} other {tool}} named {name}",
  "libraryPage.backToDrawings": "Back to drawings",
  "libraryPage.supplied": "supplied",
  "libraryPage.own": "own",
  "libraryPage.v": "v{version}",
  "libraryPage.importFromATomlFile":
    "Import {shelf, select, machines {machine} boards {board} other {tool}} from a TOML file",
  "libraryPage.chooseAMachineABoard":
    "Choose a machine, a board or a tool. To make your own, copy a supplied entry, give the copy a name, and change its values.",
  // app/Part.tsx
  "part.loading": "Loading",
  "part.thisPartOfThePage": "This part of the page cannot be loaded",
  "part.theServerDoesNotRespond":
    "The server does not respond, or it has been updated since the page was opened.",
  "part.reloadThePage": "Reload the page",
  // app/Picture.tsx
  "picture.theDielineAndThePath":
    "The dieline and the path of the machine head. Arrow keys move the view, plus and minus zoom, the key F shows the whole drawing.",
  // app/StationPage.tsx
  "stationPage.theSheetOnTheTable":
    "The sheet on the table, the path of the head, and the head while a job runs.",
  "stationPage.backToAllDrawings": "Back to all drawings",
  "stationPage.loadingTheMachine": "Loading the machine",
  "stationPage.thereIsNoMachineNamed":
    "There is no machine named {name}. Open the drawings and choose a machine there.",
  "stationPage.noConnectionToTheServer":
    "<b>No connection to the server.</b> This page may be out of date, and its buttons have no effect. In danger, use the emergency stop of the machine.",
  "stationPage.noJobWaitsForThis": "No job waits for this machine.",
  "stationPage.jobOrMachine": "Job or machine",
  "stationPage.job": "Job",
  "stationPage.moveMachine": "Move machine",
  "stationPage.theQueueOfThisMachine":
    "The queue of this machine is empty. A job appears here as soon as it is sent to the machine.",
  // app/StatusBar.tsx
  "statusBar.fileUnits": "file units",
  "statusBar.xY": "X {x}  Y {y} {unit}",
  // app/TopBar.tsx
  "topBar.knifetipShowAllDrawings": "knifetip: show all drawings",
  "topBar.viewsAndAccount": "Views and account",
  "topBar.showOrHideTheLeft": "Show or hide the left panel (key [)",
  "topBar.undoTheLastChangeCtrl": "Undo the last change (Ctrl Z)",
  "topBar.redoTheUndoneChangeCtrl": "Redo the undone change (Ctrl Shift Z)",
  "topBar.endedJobsStatisticsAndTools": "Ended jobs, statistics and tools",
  "topBar.keyboardAndMouseShortcuts": "Keyboard and mouse shortcuts (?)",
  "topBar.showOrHideTheRight": "Show or hide the right panel (key ])",
  // app/WebGlError.tsx
  "webGlError.theDrawingCannotBeDisplayed": "The drawing cannot be displayed",
  "webGlError.toSeeTheDrawingTurn":
    "{why} To see the drawing, turn on hardware acceleration in the browser settings, or use a current Firefox, Chrome, Edge or Safari. The rest of this page works without it.",
  "webGlError.reloadThePage": "Reload the page",
  // app/WebhooksPage.tsx
  "webhooksPage.webhooks": "Webhooks",
  "webhooksPage.addAWebhook": "Add a webhook",
  "webhooksPage.backToDrawings": "Back to drawings",
  "webhooksPage.changesOfJobsAndDrawings":
    "Changes of jobs and drawings are sent to these URLs as signed requests (Standard Webhooks). There are no webhooks yet.",
  "webhooksPage.changesOfJobsAndDrawings2":
    "Changes of jobs and drawings are sent to these URLs as signed requests (Standard Webhooks).",
  "webhooksPage.newWebhook": "New webhook",
  "webhooksPage.add": "Add",
  // app/Welcome.tsx
  "welcome.dropADielineFileHere": "Drop a dieline file here",
  "welcome.dxfSvgCf2PdfHpgl":
    "DXF, SVG, CF2, PDF, HPGL or LightBurn. knifetip recognises cuts, creases and grooves, calculates the tool paths for your machine, and checks the program before the machine moves.",
  "welcome.n1Open": "1. Open",
  "welcome.dropADrawingFileOr": "Drop a drawing file, or choose a drawing from the list.",
  "welcome.n2Prepare": "2. Prepare",
  "welcome.chooseAMachineAndA":
    "Choose a machine and a board, prepare the machine program, and see how far it deviates from the drawing.",
  "welcome.n3Send": "3. Send",
  "welcome.sendTheJobToThe":
    "Send the job to the machine. The operator checks the table there and starts it. Follow the progress.",
  // app/ZoomControls.tsx
  "zoomControls.zoomInKey": "Zoom in (key +)",
  "zoomControls.zoomOutKey": "Zoom out (key −)",
  "zoomControls.showTheWholeDrawingKey": "Show the whole drawing (key F)",
  // app/theme.ts
  "theme.close": "Close",
  // panels/accounts/AccountDialog.tsx
  "accountDialog.youCanViewDrawingsJobs":
    "You can view drawings, jobs and machines, but not change them.",
  "accountDialog.youCanUploadAndChange":
    "You can upload and change drawings and order jobs. An operator must release the jobs.",
  "accountDialog.youCanOrderReleaseAnd":
    "You can order, release and control jobs, and operate machines.",
  "accountDialog.youCanDoEverythingAnd":
    "You can do everything, and manage the library, users and keys.",
  "accountDialog.accountSignInIsNot": "Account: sign-in is not set up yet",
  "accountDialog.account": "Account: {name}",
  "accountDialog.account2": "Account",
  "accountDialog.myAccount": "My account",
  "accountDialog.users": "Users",
  "accountDialog.apiKeys": "API keys",
  "accountDialog.auditLog": "Audit log",
  "accountDialog.signedInAs": "Signed in as <strong>{name}</strong> ({role}).",
  "accountDialog.signOut": "Sign out",
  "accountDialog.yourPasswordAndYourRole":
    "Your password and your role are managed by the provider with which you sign in.",
  "accountDialog.thisDeviceIsPairedWith":
    "This device, <strong>{name}</strong>, is paired with {machines}. It may start, continue and move this machine, and sees its jobs.",
  "accountDialog.unpairThisDevice": "Unpair this device",
  "accountDialog.noAdministratorExistsYetEvery":
    "No administrator exists yet. Every program on this computer has full access, and other computers have none. Create the first administrator here or with this command:",
  "accountDialog.createTheAdministrator": "Create the administrator",
  "accountDialog.name": "Name",
  "accountDialog.password": "Password",
  "accountDialog.atLeastTenCharacters": "At least ten characters",
  "accountDialog.passwordChangedYourOtherSessions":
    "Password changed. Your other sessions were signed out.",
  "accountDialog.changeThePassword": "Change the password",
  "accountDialog.currentPassword": "Current password",
  "accountDialog.newPassword": "New password",
  "accountDialog.userCreated": "User {name} created.",
  "accountDialog.createAUser": "Create a user",
  "accountDialog.role": "Role",
  "accountDialog.neverSignedIn": "never signed in",
  "accountDialog.disabled": "disabled",
  "accountDialog.roleOf": "Role of {name}",
  "accountDialog.disable": "Disable",
  "accountDialog.enable": "Enable",
  "accountDialog.copyTheKeyNowIt": "Copy the key now. It cannot be shown again.",
  "accountDialog.neverUsed": "never used",
  "accountDialog.used": "used {used}",
  "accountDialog.customer": "customer {customer}",
  "accountDialog.anyMachine": "any machine",
  "accountDialog.expires": "expires {expires}",
  "accountDialog.revoke": "Revoke",
  "accountDialog.revoked": "revoked",
  "accountDialog.createAKey": "Create a key",
  "accountDialog.usedBy": "Title of the key",
  "accountDialog.programThatUsesTheKey": "Program that uses the key",
  "accountDialog.scopes": "Scopes",
  "accountDialog.noRoleLetsAKey":
    "To start or move a machine, a key needs the scope station: no other scope includes it",
  "accountDialog.customerOptional": "Customer (optional)",
  "accountDialog.theKeySeesAndOrders": "The key sees and orders only jobs of this customer",
  "accountDialog.machinesOptional": "Machines (optional)",
  "accountDialog.theKeyIsForThese": "The key is for these machines only",
  "accountDialog.expiresOptional": "Expires (optional)",
  "accountDialog.unknown": "unknown",
  // panels/accounts/OperatorForm.tsx
  "operatorForm.nameOfTheOperator": "Name of the operator",
  "operatorForm.yourName": "Your name",
  "operatorForm.whoWorksAtThisDevice": "Who works at this device?",
  "operatorForm.save": "Save",
  "operatorForm.noName": "No name",
  "operatorForm.cancel": "Cancel",
  "operatorForm.recordedWithWhatYouConfirm":
    "Your name is recorded with what you confirm or change, and kept on this device.",
  "operatorForm.operator": "Operator",
  "operatorForm.changeTheNameOfThe": "Change the name of the operator",
  // panels/accounts/PairedDevices.tsx
  "pairedDevices.pairedDevices": "Paired devices",
  "pairedDevices.pairADevice": "Pair a device",
  "pairedDevices.notUsedYet": "not used yet",
  "pairedDevices.lastUsed": "last used {used}",
  "pairedDevices.revoke": "Revoke {title}",
  "pairedDevices.revoke2": "Revoke",
  "pairedDevices.openPairOnTheDevice":
    "Open <b>{origin}/pair</b> on the device and enter <output>{code}</output> until {expires}. The code is for one device, which may then start and move this machine.",
  // panels/drawing/ColourBar.tsx
  "colourBar.whatTheColoursOfThe": "What the colours of the drawing show",
  "colourBar.blueEdgesHave0Mm":
    "{title}: blue edges have 0 mm, yellow edges {limit, number, ::group-off} mm, red edges more; grey edges are neither cut nor creased",
  "colourBar.neitherCutNorCreased": "neither cut nor creased",
  "colourBar.moreThanMm": "more than {limit, number, ::group-off} mm",
  // panels/drawing/DocumentPanel.tsx
  "documentPanel.editTheRulesOfThis": "Edit the rules of this profile",
  "documentPanel.drawingSize": "Drawing size",
  "documentPanel.unitUnknown": "{width} × {height}, unit unknown",
  "documentPanel.sizeInInches": "Size in inches",
  "documentPanel.numberOfEdges": "Number of edges",
  "documentPanel.withALineTypeSet":
    "{segments, number}, {overrides, number} with a line type set by hand",
  "documentPanel.importReport": "Import report",
  "documentPanel.profileRulesForLineTypes": "Profile (rules for line types)",
  "documentPanel.deletedProfile": "Deleted profile",
  "documentPanel.customerProfiles": "Customer profiles",
  "documentPanel.builtInProfiles": "Built-in profiles",
  "documentPanel.thisProfileWasDeleted": "This profile was deleted",
  "documentPanel.applyTheChangedProfileTo": "Apply the changed profile to the drawing",
  "documentPanel.theProfileHasChangedSince":
    "The profile has changed since it was applied to this drawing.",
  "documentPanel.thisProfileWasDeletedThe":
    "This profile was deleted. The drawing still uses the rules of the deleted profile.",
  // panels/drawing/DrawingsPanel.tsx
  "drawingsPanel.drawings": "Drawings",
  "drawingsPanel.thereAreNoDrawingsYet":
    "There are no drawings yet. Drop a drawing (DXF, SVG, CF2, PDF, HPGL or LightBurn) on this page.",
  "drawingsPanel.questions": "{questions, plural, one {# question} other {# questions}}",
  "drawingsPanel.unitUnknown": "unit unknown",
  "drawingsPanel.edges": "{width} · {segments, plural, one {# edge} other {# edges}}",
  "drawingsPanel.openDrawingFiles": "Open drawing files",
  // panels/drawing/EdgeQuestion.tsx
  "edgeQuestion.edges": "{rows, plural, one {# edge} other {# edges}}",
  "edgeQuestion.nothingInTheFileSuggests":
    "Nothing in the file suggests a line type for these edges. Choose the line type.",
  "edgeQuestion.mostLikely": "most likely ({percent, number} %)",
  // panels/drawing/FollowingEdges.tsx
  "followingEdges.alsoDecided": "Also decided by this answer:",
  "followingEdges.typeByAnswer": "{type} if the answer is {answer}",
  // panels/drawing/EdgeTooltip.tsx
  "edgeTooltip.layerInFile": "Layer in file",
  "edgeTooltip.objectInFile": "Object in file",
  "edgeTooltip.edgeNumber": "(edge number {row})",
  "edgeTooltip.reasonForLineType": "Reason for line type",
  "edgeTooltip.deviationFromDrawing": "Deviation from drawing",
  "edgeTooltip.overcutLength": "Overcut length",
  "edgeTooltip.uncutLength": "Uncut length",
  "edgeTooltip.gapAtEachEndOf": "Gap at each end of the edge",
  "edgeTooltip.toolPathOffTheEdge": "Distance of tool path from edge",
  "edgeTooltip.cornerRoundingByController": "Corner rounding by controller",
  "edgeTooltip.edgeOffTheCurveIn": "Distance of edge from curve in file",
  "edgeTooltip.grooveWidth": "Groove width",
  "edgeTooltip.boardThicknessUnderGroove": "Board thickness under groove",
  "edgeTooltip.positionErrorOfGrooveSides": "Position error of groove sides",
  "edgeTooltip.unreachableLength": "Unreachable length",
  "edgeTooltip.moveAboveBoard": "Move above board",
  "edgeTooltip.plungeIntoBoard": "Plunge into board",
  "edgeTooltip.leadIn": "Lead-in",
  "edgeTooltip.cutOrCrease": "Cut or crease",
  "edgeTooltip.toolTurn": "Tool turn",
  "edgeTooltip.leadOut": "Lead-out",
  "edgeTooltip.liftOutOfBoard": "Lift out of board",
  "edgeTooltip.toolStation": "Tool station {tool}",
  "edgeTooltip.tipHeightMm": "tip height {height} mm",
  "edgeTooltip.programLine": "program line {line, number}",
  "edgeTooltip.andMoreMoves": "… and {rows, number} more moves",
  "edgeTooltip.atTheTopFace": "{width} at the top face",
  "edgeTooltip.upToFromTheCut": "{length}, up to {distance} from the cut",
  // panels/drawing/Entities.tsx
  "entities.thisObjectHasNoPosition": "This object has no position in the drawing",
  "entities.showThePositionOfThis": "Show the position of this object in the drawing",
  "entities.onLayer": "{handle} on layer {layer}",
  "entities.onLayer2": "{kind} {handle} on layer {layer}",
  // panels/drawing/ImportPanel.tsx
  "importPanel.kept": "Kept",
  "importPanel.merged": "Merged",
  "importPanel.dropped": "Dropped",
  "importPanel.importReport": "Import report",
  "importPanel.all": "All",
  "importPanel.listObjectsWithThisImport": "List objects with this import result",
  "importPanel.noObjectOfThisFile":
    "No object of this file was {outcome, select, kept {kept} merged {merged} other {dropped}}.",
  "importPanel.totalLengthsOfTheLines":
    "Total lengths of the lines that the import kept, merged and dropped",
  "importPanel.totalLength": "Total length",
  "importPanel.keptAsDrawn": "Kept as drawn",
  "importPanel.listTheseObjectsOfThe": "List these objects of the file",
  "importPanel.edges": "{count, plural, one {# edge} other {# edges}}",
  "importPanel.objects": "{count, plural, one {# object} other {# objects}}",
  // panels/drawing/InheritedRules.tsx
  "inheritedRules.rulesTakenFromTheProfile": "Rules taken from the profile “{title}”",
  "inheritedRules.rulesEdges":
    "{rules, plural, one {# rule} other {# rules}}, {edges, plural, one {# edge} other {# edges}}",
  // panels/drawing/InspectorPanel.tsx
  "inspectorPanel.selectedEdge": "Selected edge {row}",
  "inspectorPanel.selectedEdges": "{rows, plural, one {# selected edge} other {# selected edges}}",
  "inspectorPanel.andMoreReasonsForThe":
    "… and {more, number} more reasons for the line types of the selected edges",
  "inspectorPanel.selectAllEdgesWithThis":
    "Select all {alike, number} edges with this layer and colour",
  "inspectorPanel.edges": "{decided, plural, one {# edge} other {# edges}}",
  "inspectorPanel.confidence": "{confidence, number} % confidence",
  "inspectorPanel.otherPossibleLineTypesClick": "Other possible line types (click to set)",
  "inspectorPanel.objectInFile": "Object in file",
  "inspectorPanel.layerInFile": "Layer in file",
  "inspectorPanel.colourInFile": "Colour in file",
  "inspectorPanel.lineStyleInFile": "Line style in file",
  "inspectorPanel.lineWidthInFile": "Line width in file",
  "inspectorPanel.importResult": "Import result",
  // panels/drawing/LayersPanel.tsx
  "layersPanel.layersInTheFile": "Layers in the file",
  "layersPanel.selectAllEdgesOnLayer": "Select all edges on layer {name} with colour {colour}",
  "layersPanel.lineTypeOfLayer": "Line type of layer {name}",
  "layersPanel.setTheLineTypeOf": "Set the line type of layer {name}",
  "layersPanel.showLayer": "Show layer {name}",
  "layersPanel.hideLayer": "Hide layer {name}",
  // panels/drawing/LearnedPanel.tsx
  "learnedPanel.rulesSuggestedFromTheLine": "Rules suggested from the line types that you set",
  "learnedPanel.treatEveryEdgeThatMatches":
    "Treat every edge that matches <b>{conditions}</b> as <line>{type}</line>",
  "learnedPanel.matchesEdgesThatYouSet":
    "Matches {explains, plural, one {# edge} other {# edges}} that you set by hand. No other edge changes.",
  "learnedPanel.matchesEdgesThatYouSet2":
    "Matches {explains, plural, one {# edge} other {# edges}} that you set by hand. Also sets the line type of edges that have none:",
  "learnedPanel.matchesEdgesThatYouSet3":
    "Matches {explains, plural, one {# edge} other {# edges}} that you set by hand. Also changes the line type of other edges:",
  "learnedPanel.newProfile": "New profile",
  "learnedPanel.nameOfTheNewProfile": "Name of the new profile",
  "learnedPanel.saveRule": "Save rule",
  "learnedPanel.addRuleToProfile": "Add rule to profile {title}",
  // panels/drawing/LineTypesPanel.tsx
  "lineTypesPanel.lineTypes": "Line types",
  "lineTypesPanel.selectAllEdges": "Select all {title} edges",
  "lineTypesPanel.showEdges": "Show {title} edges",
  "lineTypesPanel.hideEdges": "Hide {title} edges",
  // panels/drawing/PagesPanel.tsx
  "pagesPanel.pagesOfTheFile": "Pages of the file",
  "pagesPanel.pageIsRead": "page {page} is read",
  "pagesPanel.thePagesCannotBeShown": "The pages cannot be shown.",
  "pagesPanel.thePagesAreBeingRead": "The pages are being read …",
  "pagesPanel.chooseAPageToOpen": "Choose a page to open it as a drawing of its own.",
  "pagesPanel.thePageThatIsRead": "The page that is read",
  "pagesPanel.page": "Page {page}",
  "pagesPanel.noDrawing": "no drawing",
  "pagesPanel.edges": "{edges, plural, one {# edge} other {# edges}}",
  // panels/drawing/PathLegend.tsx
  "pathLegend.toolEntersBoard": "tool enters board",
  "pathLegend.toolTurnsOnTheSpot": "tool turns on the spot",
  "pathLegend.toolLeavesBoard": "tool leaves board",
  "pathLegend.noCutWidthsToShow":
    "No cut widths to show: every tool of this program cuts on the line itself.",
  "pathLegend.removesAStripWide": "removes a strip {radius} wide",
  "pathLegend.cutsAGrooveWideAt": "cuts a groove {depth} wide at the top face, {depth2} deep",
  "pathLegend.pressesOnOfTheCrease": "presses on {radius} of the crease at a time, {depth} deep",
  // panels/drawing/PreparationBanner.tsx
  "preparationBanner.firstStartOfTheServer":
    "First start of the server: {compiled, number} of {parts, number} software modules are ready",
  "preparationBanner.firstStartOfTheServer2": "First start of the server",
  "preparationBanner.theServerPreparesItsSoftware":
    "The server prepares its software modules only once, after the installation. You can already work: a drawing or job that needs a module waits until this module is ready.",
  // panels/drawing/ProfileEditor.tsx
  "profileEditor.backToTheDrawing": "Back to the drawing",
  "profileEditor.thisProfileWasDeletedAnd": "This profile was deleted and cannot be edited.",
  "profileEditor.yourUnsavedEditsAreKept": "{back} (your unsaved edits are kept)",
  "profileEditor.newProfile": "New profile",
  "profileEditor.saveAndApplyToDrawing": "Save and apply to drawing",
  "profileEditor.discardEdits": "Discard edits",
  "profileEditor.closeEditor": "Close editor",
  "profileEditor.nameOfTheProfile": "Name of the profile",
  "profileEditor.eGNameOfThe": "e.g. name of the customer",
  "profileEditor.builtInProfileWhoseRules": "Built-in profile whose rules are also used",
  "profileEditor.noneOnlyTheRulesBelow": "None (only the rules below)",
  "profileEditor.applyTheRulesBelowBefore": "Apply the rules below before the built-in rules",
  "profileEditor.rulesTheFirstRuleThat": "Rules (the first rule that matches an edge decides)",
  "profileEditor.addRule": "Add rule",
  "profileEditor.thisProfileHasNoRules":
    "This profile has no rules of its own yet. Add a rule, or set line types of edges by hand and save a rule that knifetip suggests.",
  "profileEditor.outcome":
    "{changed, plural, =0 {These rules change no line type in this drawing} one {These rules change the line type of # edge in this drawing} other {These rules change the line type of # edges in this drawing}}{open, plural, =0 {} one {; # edge matches no rule} other {; # edges match no rule}}.",
  "profileEditor.edgesSetByHandKeep": "Edges set by hand keep their line type.",
  // panels/drawing/ProfileFiles.tsx
  "profileFiles.downloadThisProfileAsA": "Download this profile as a TOML file",
  "profileFiles.importAProfileFromA": "Import a profile from a TOML file",
  "profileFiles.deleteThisProfile": "Delete this profile",
  // panels/drawing/QuestionTable.tsx
  "questionTable.chooseALineTypeFor":
    "Choose a line type for each row, and set all of them at once.",
  "questionTable.layerAndEdges": "Layer and edges",
  "questionTable.lineType": "Line type",
  "questionTable.oneUndoTakesAllOf": "One undo reverts all of these answers",
  "questionTable.ofRows": "{answers, number} of {questions, plural, one {# row} other {# rows}}",
  "questionTable.setTheChosenLineTypes": "Set the chosen line types",
  "questionTable.edges": "{edges, plural, one {# edge} other {# edges}}",
  "questionTable.lineTypeOfEdges":
    "Line type of {title}, {edges, plural, one {# edge} other {# edges}}",
  "questionTable.choose": "Choose …",
  // panels/drawing/QuestionsPanel.tsx
  "questionsPanel.openQuestions":
    "{questions, plural, one {# open question} other {# open questions}}",
  "questionsPanel.oneUndoTakesAllOf": "One undo reverts all of these answers",
  "questionsPanel.questions": "{suggested, plural, one {# question} other {# questions}}",
  "questionsPanel.acceptAllMostLikelyLine": "Accept the most likely line type for all questions",
  "questionsPanel.theEdgesStayVisibleIn":
    "The edges stay visible in the drawing, but they are neither cut nor creased",
  "questionsPanel.edges": "{undecided, plural, one {# edge} other {# edges}}",
  "questionsPanel.setAllUndecidedEdgesTo": "Set all undecided edges to ignored",
  // panels/drawing/RuleCard.tsx
  "ruleCard.layerName": "Layer name",
  "ruleCard.colour": "Colour",
  "ruleCard.lineStyleInFile": "Line style in file",
  "ruleCard.objectTypeInFile": "Object type in file",
  "ruleCard.blockName": "Block name",
  "ruleCard.eGFoldsCrease": "e.g. FOLDS, crease*",
  "ruleCard.eG1Ff0000": "e.g. 1, #ff0000",
  "ruleCard.eGDash": "e.g. *DASH*",
  "ruleCard.eGLineArc": "e.g. LINE, ARC",
  "ruleCard.eGCrease": "e.g. *CREASE*",
  "ruleCard.dragToChangeTheOrder": "Drag to change the order of the rules",
  "ruleCard.lineTypeOfRule": "Line type of rule {number}",
  "ruleCard.edges": "{edges, plural, one {# edge} other {# edges}}",
  "ruleCard.moveThisRuleUpApplied": "Move this rule up (applied earlier)",
  "ruleCard.moveThisRuleDownApplied": "Move this rule down (applied later)",
  "ruleCard.deleteThisRule": "Delete this rule",
  "ruleCard.thisRuleHasNoCondition": "This rule has no condition: it matches every edge.",
  "ruleCard.showMoreConditionsForThis": "Show more conditions for this rule",
  "ruleCard.ofRule": "{condition} of rule {number}",
  // panels/drawing/Scrubber.tsx
  "scrubber.pauseThePreviewOfThe": "Pause the preview of the program",
  "scrubber.playAPreviewOfThe": "Play a preview of the program",
  "scrubber.timeInThePreviewOf": "Time in the preview of the program",
  "scrubber.machineTimeUpToThe":
    "Machine time up to the shown position / machine time of the whole program",
  // panels/drawing/SelectionBar.tsx
  "selectionBar.setTheLineTypeOf": "Set the line type of the selected edges",
  "selectionBar.edgesSelected": "{rows, plural, one {# edge} other {# edges}} selected",
  "selectionBar.setTheLineTypeTo": "Set the line type to {title} (key {key})",
  "selectionBar.setTheLineTypeTo2": "Set the line type to {title}",
  "selectionBar.key0": "{useprofiletype} (key 0)",
  "selectionBar.clearTheSelectionOfEdges": "Clear the selection of edges",
  // panels/drawing/ShareControl.tsx
  "shareControl.itsOwnerOrAnOperator": "The owner of the drawing or an operator can share it.",
  "shareControl.allDesignersMayChangeThis": "All designers may change this drawing",
  // panels/drawing/TaughtPanel.tsx
  "taughtPanel.decidedFromAnswers": "Decided from earlier answers",
  "taughtPanel.moreEdgesWithTheLook":
    "<b>{rows, plural, one {# more edge} other {# more edges}}</b> with the same layer, colour and line style as edges that you answered",
  "taughtPanel.edges": "{edges, plural, one {# edge} other {# edges}}",
  "taughtPanel.learnedFromOf": "{look}. Learned from {drawings} of {customer}.",
  "taughtPanel.askAboutSuchEdgesIn": "Ask about such edges, in this drawing and in the next ones",
  "taughtPanel.takeBackFor": "Stop using this answer for {customer}",
  "taughtPanel.useAgain": "Use this answer again",
  "taughtPanel.noLongerDecidedAs": "{look} ({look2}): the line type {title} is no longer assigned.",
  // panels/drawing/TypeChanges.tsx
  "typeChanges.becomes": "becomes",
  "typeChanges.edges": "{edges, plural, one {# edge} other {# edges}}",
  // panels/drawing/UnitPanel.tsx
  "unitPanel.unitOfLengthInThe": "Unit of length in the file",
  "unitPanel.warningAboutTheUnit": "Warning about the unit",
  "unitPanel.asInDrawings":
    "The file states no unit. This is the unit that was chosen for {drawings} of this customer.",
  "unitPanel.setByHand": "{title}, set by hand",
  "unitPanel.letKnifetipDetectTheUnit": "Let knifetip detect the unit from the file again",
  "unitPanel.aLongerBarShowsStronger": "A longer bar shows stronger evidence for this unit",
  "unitPanel.thisUnitIsUsed": "This unit is used",
  "unitPanel.mostLikely": "most likely",
  "unitPanel.hideTheEvidenceForOther": "Hide the evidence for other units",
  "unitPanel.showTheEvidenceForOther": "Show the evidence for other units",
  // panels/drawing/UnitQuestion.tsx
  "unitQuestion.whichUnitOfLengthDoes": "Which unit of length does the file use?",
  // panels/drawing/ViewBar.tsx
  "viewBar.drawing": "Drawing",
  "viewBar.theEdgesOfTheDrawing": "the edges of the drawing",
  "viewBar.headPath": "Head path",
  "viewBar.thePathOfTheMachine": "the path of the machine head",
  "viewBar.pathOfToolTip": "Path of tool tip",
  "viewBar.thePathOfTheTool": "the path of the tool tip",
  "viewBar.movesAboveBoard": "Moves above board",
  "viewBar.theMovesOfTheMachine": "the moves of the machine head above the board",
  "viewBar.toolWidth": "Tool width",
  "viewBar.theAreaThatTheTools": "the area that the tools cut or press",
  "viewBar.plungesAndLifts": "Plunges and lifts",
  "viewBar.thePointsWhereATool":
    "the points where a tool enters the board, turns on the spot or leaves the board",
  "viewBar.unreachableAreas": "Unreachable areas",
  "viewBar.areasThatTheToolCannot": "areas that the tool cannot reach",
  "viewBar.chooseWhatTheViewShows": "Choose what the view shows",
  "viewBar.prepareTheProgramFirstRight": "Prepare the program first (right panel, New job)",
  "viewBar.showOrHide": "Show or hide {shows}",
  // panels/history/HistoryPage.tsx
  "historyPage.endedJobs": "Ended jobs",
  "historyPage.statistics": "Statistics",
  "historyPage.tools": "Tools",
  "historyPage.finished": "Finished",
  "historyPage.cancelled": "Cancelled",
  "historyPage.boardScrapped": "Board scrapped",
  "historyPage.interrupted": "Interrupted",
  "historyPage.continuedByAnotherJob": "Continued by another job",
  "historyPage.refused": "Refused",
  "historyPage.drawingName": "Drawing name",
  "historyPage.orderNumber": "Order number",
  "historyPage.customer": "Customer",
  "historyPage.allTimes": "All times",
  "historyPage.last24Hours": "Last 24 hours",
  "historyPage.last7Days": "Last 7 days",
  "historyPage.last31Days": "Last 31 days",
  "historyPage.lastYear": "Last year",
  "historyPage.history": "History",
  "historyPage.whatToShow": "View of the history",
  "historyPage.machine": "Machine",
  "historyPage.allMachines": "All machines",
  "historyPage.backToTheDrawing": "Back to the drawing",
  "historyPage.board": "Board",
  "historyPage.allBoards": "All boards",
  "historyPage.state": "State",
  "historyPage.allStates": "All states",
  "historyPage.period": "Period",
  "historyPage.noJobMeetsTheseConditions": "No job meets these conditions.",
  "historyPage.copies": "{copies, plural, one {# copy} other {# copies}}",
  "historyPage.ofCopies": "{copiesDone, number} of {copies, plural, one {# copy} other {# copies}}",
  // panels/history/StatisticsView.tsx
  "statisticsView.days": "Days",
  "statisticsView.weeks": "Weeks",
  "statisticsView.months": "Months",
  "statisticsView.cut": "cut",
  "statisticsView.creased": "creased",
  "statisticsView.grooved": "grooved",
  "statisticsView.perforated": "perforated",
  "statisticsView.halfCut": "half-cut",
  "statisticsView.cutAndCreased": "cut and creased",
  "statisticsView.weekOf": "Week of {text}",
  "statisticsView.lengthOfAPeriod": "Group by days, weeks or months",
  "statisticsView.noJobHasRunOn": "No job has run on a machine in this time.",
  "statisticsView.copies": "{copies, plural, one {# copy} other {# copies}}",
  "statisticsView.jobsFinished": "{jobs, plural, one {# job} other {# jobs}} finished",
  "statisticsView.sheets": "Sheets",
  "statisticsView.length": "Length",
  "statisticsView.onTheMachine": "Time on the machine",
  "statisticsView.interrupted": "Interrupted",
  "statisticsView.ofRuns":
    "{interruptions, number} of {runs, plural, one {# run} other {# runs}} ({interruptedShare, number} %)",
  // panels/history/ToolsView.tsx
  "toolsView.noChangeRecorded": "No change recorded",
  "toolsView.changed": "Changed {changed} ({changedBy})",
  "toolsView.of": "{used} of {life}",
  "toolsView.lifeOfInMetres0": "Life of {name} in metres, 0 for no limit",
  "toolsView.life": "Life",
  "toolsView.toolChanged": "Tool changed",
  "toolsView.isThereANewTool": "Is there a new tool in station {station}?",
  "toolsView.theRecordedLengthOfBecomes":
    "The recorded length of {name} becomes 0. Confirm only if the tool was changed.",
  "toolsView.toolWasChanged": "Tool was changed",
  "toolsView.notChanged": "Not changed",
  // panels/job/AcceptForm.tsx
  "acceptForm.theProgramIsSafeYou":
    "The program is safe. You can accept these lines as they will be made:",
  "acceptForm.reason": "Reason",
  "acceptForm.yourName": "Your name",
  "acceptForm.acceptTheSameShortfallsAs":
    "Accept the same {same, plural, one {# shortfall} other {# shortfalls}} as before",
  "acceptForm.acceptShortfalls": "Accept {chosen, plural, one {# shortfall} other {# shortfalls}}",
  "acceptForm.acceptedOfTheseLinesFor":
    "{names} accepted {findings, number} of these lines for the job of {time}. Accept them again for this job, with your name.",
  "acceptForm.unreached":
    "{count, plural, one {# line cannot be reached by the tool} other {# lines cannot be reached by the tool}}",
  "acceptForm.kerf":
    "{count, plural, one {# line becomes as wide as the tool} other {# lines become as wide as the tool}}",
  "acceptForm.fold":
    "{count, plural, one {# line does not fold far enough} other {# lines do not fold far enough}}",
  "acceptForm.uncut":
    "{count, plural, one {# line cannot be made over its whole length} other {# lines cannot be made over their whole length}}",
  "acceptForm.beside":
    "{count, plural, one {# line bends more tightly than the tool can follow} other {# lines bend more tightly than the tool can follow}}",
  "acceptForm.near":
    "{count, plural, one {# line lies close beside another line} other {# lines lie close beside other lines}}",
  "acceptForm.deviation":
    "{count, plural, one {# line differs from the drawn curve} other {# lines differ from the drawn curve}}",
  "acceptForm.other": "{count, plural, one {# line} other {# lines}}: {kind}",
  // panels/job/JobPanel.tsx
  "jobPanel.showTheDrawingWithoutAJob": "Show the drawing without a job",
  "jobPanel.openJob": "Open job",
  "jobPanel.downloadRefusedProgramLines":
    "Download refused program ({lines, plural, one {# line} other {# lines}})",
  "jobPanel.downloadMachineProgramLines":
    "Download machine program ({lines, plural, one {# line} other {# lines}})",
  "jobPanel.board": "Board: <b>{title}</b> · {machine}",
  "jobPanel.restOfTheSheetOr": "Continue this sheet, or make one more copy",
  "jobPanel.theJobWaitsForThe": "The job waits for the machine {machine}.",
  "jobPanel.progressOfTheJobOn": "Progress of the job on the table",
  "jobPanel.done": "{progress, number} % done",
  "jobPanel.copyOf": "copy {copiesDone, number} of {copies, number}",
  "jobPanel.programLineOf": "program line {line, number} of {lines, number}",
  "jobPanel.left": "{left} left",
  "jobPanel.copiesFinished": "{copies, plural, one {# copy} other {# copies}} finished",
  "jobPanel.theTableIsFreeFor": "The table is free for the next job.",
  "jobPanel.theJobWasCancelled": "The job was cancelled.",
  "jobPanel.showEdgesInTheDrawing":
    "Show {rows, plural, one {# edge} other {# edges}} in the drawing",
  "jobPanel.sendJobToMachine": "Send job to machine",
  "jobPanel.compileJobAgain": "Compile job again",
  "jobPanel.pauseJob": "Pause job",
  "jobPanel.cancelJob": "Cancel job",
  "jobPanel.markJobAsFinished": "Mark job as finished",
  "jobPanel.letTheMachineTryAgain": "Let the machine try again",
  "jobPanel.queueJobAgain": "Queue job again",
  "jobPanel.endJobBoardIsScrap": "End job, board is scrap",
  // panels/job/MachineChip.tsx
  "machineChip.theKnifetipServerDoesNot":
    "The knifetip server does not respond. The page keeps trying to connect.",
  "machineChip.loadingTheListOfMachines": "Loading the list of machines",
  "machineChip.isConnected": "{title} is connected",
  "machineChip.isNotConnectedSoIts": "{title} is not connected, so its jobs wait in the queue.",
  "machineChip.serverNotReachable": "Server not reachable",
  "machineChip.offline": "offline",
  "machineChip.free": "free",
  "machineChip.waiting": "waiting",
  "machineChip.interrupted": "interrupted",
  "machineChip.busy": "busy",
  // panels/job/MachinePanel.tsx
  "machinePanel.carriageAxes": "Carriage {number}: axes {axes}",
  "machinePanel.parksAtMm": "parks at {axis} {park} mm",
  "machinePanel.xTo": "X {x} to {x2}",
  "machinePanel.yTo": "Y {y} to {y2}",
  "machinePanel.mmHigh": "{top, number, ::group-off} mm high",
  "machinePanel.machineAndTools": "Machine and tools",
  "machinePanel.openStationPage": "Open station page",
  "machinePanel.machinesAndBoards": "Machines and boards",
  "machinePanel.webhooks": "Webhooks",
  "machinePanel.controllerLanguage": "{title}, controller language {language}",
  "machinePanel.keepOutZonesWhichNo": "Keep-out zones, which no tool may touch",
  "machinePanel.connected": "Connected",
  "machinePanel.notConnected": "Not connected",
  // panels/job/MachineQueue.tsx
  "machineQueue.queueOf": "Queue of {title}",
  "machineQueue.waiting": "{ids, number} waiting",
  "machineQueue.noJobWaitsForThis": "No job waits for this machine.",
  "machineQueue.copiesDone":
    "{copies, plural, one {# copy} other {# copies}}, {copiesDone, number} done",
  "machineQueue.copies": "{copies, plural, one {# copy} other {# copies}}",
  "machineQueue.progressOf": "Progress of {drawingName}",
  "machineQueue.moveUp": "Move {name} up",
  "machineQueue.moveDown": "Move {name} down",
  "machineQueue.endTheHoldOf": "End the hold of {name}",
  "machineQueue.holdInTheQueue": "Hold {name} in the queue",
  "machineQueue.copiesOf": "Copies of {name}",
  "machineQueue.priorityAndMachineOf": "Priority and machine of {name}",
  "machineQueue.moveToTheTop": "Move to the top",
  "machineQueue.priority": "Priority",
  "machineQueue.moveToMachine": "Move to machine",
  // panels/job/QueuePanel.tsx
  "queuePanel.otherJobs": "Other jobs",
  "queuePanel.thereAreNoJobsYet":
    "There are no jobs yet. To create a job, open a drawing and prepare its program.",
  "queuePanel.copies": "{copies, number} copies",
  "queuePanel.machineTime": "machine time {seconds}",
  "queuePanel.progressOf": "Progress of {drawingName}",
  // panels/job/RemainingCopies.tsx
  "remainingCopies.queueTheRemainingCopies":
    "Queue the remaining {remainingCopies, plural, one {# copy} other {# copies}}",
  // panels/job/RestPanel.tsx
  "restPanel.continueFromHere": "Continue from here",
  "restPanel.onlyThisTool": "Only this tool",
  "restPanel.oneMoreCopy": "One more copy",
  "restPanel.cut": "cut",
  "restPanel.begun": "begun",
  "restPanel.notCut": "not cut",
  "restPanel.notKnown": "not known",
  "restPanel.orBeginAtAProgram": "Or begin at a program line",
  "restPanel.theNewJobBeginsWith": "The new job begins with the track of this line.",
  "restPanel.line": "Line",
  "restPanel.iHaveCheckedOnThe":
    "I have checked on the sheet: {count, plural, one {# track left out ({tracks}) is} other {# tracks left out ({tracks}) are}} completely made",
  "restPanel.iHaveCheckedOnThe2":
    "I have checked on the sheet: {count, plural, one {# track reported as cut ({tracks}) has} other {# tracks reported as cut ({tracks}) have}} not cut through the board",
  "restPanel.queueOneMoreCopy": "Queue one more copy",
  "restPanel.continueThisSheetTracksLeft":
    "Continue this sheet, {chosen, plural, one {# track} other {# tracks}} left",
  "restPanel.itIsNotKnownHow":
    "It is not known how far the machine went. Look at the sheet, and state for each of these {unknown, plural, one {# track} other {# tracks}} whether it is completely made. Touch a track in the picture, or answer in the list.",
  "restPanel.station": "Station {station}",
  "restPanel.made": "Made",
  "restPanel.notMade": "Not made",
  "restPanel.tracksNotAnsweredYet":
    "{open, plural, one {# track} other {# tracks}} not answered yet.",
  "restPanel.allTracksAreMadeMark": "All tracks are made. Mark the job finished below.",
  "restPanel.leaveTheSheetInIts":
    "Leave the sheet in its place. A new job makes {chosen, number} of {all, plural, one {# track} other {# tracks}}: {tracks}.",
  "restPanel.makeOneMoreCopyOn": "Make one more copy on a new sheet instead",
  "restPanel.clearTheTableANew":
    "Clear the table. A new job makes the whole program again on a new sheet.",
  "restPanel.theTrackThatWasBegun": "The track that was begun is made again from its start.",
  "restPanel.tracksReportedAsCutWill":
    "{count, plural, one {# track} other {# tracks}} reported as cut will be made again: {tracks}.",
  "restPanel.tracksOfTheProgramOn": "Tracks of the program on the sheet",
  "restPanel.trackStation": "Track {number}, station {station}, {state}",
  "restPanel.willBeMade": "will be made",
  "restPanel.lines": "lines {firstLine} – {lastLine}",
  // panels/job/VerdictCard.tsx
  "verdictCard.resultOfTheProgramCheck": "Result of the program check",
  "verdictCard.longestOvercut": "Longest overcut",
  "verdictCard.longestLengthLeftUncut": "Longest length left uncut",
  "verdictCard.totalLengthLeftOutAs": "Total length left out on purpose",
  "verdictCard.machineTime": "Machine time",
  "verdictCard.andMoreFindings":
    "… and {findings, plural, one {# more finding} other {# more findings}}.",
  "verdictCard.programMatchesTheDrawing": "Program matches the drawing",
  "verdictCard.programMatchesTheDrawingExcept":
    "Program matches the drawing, except for {exceptions, plural, one {# accepted shortfall} other {# accepted shortfalls}}",
  "verdictCard.programHasErrorsAndCannot": "Program has errors and cannot be sent",
  "verdictCard.toolCannotMakeEveryLine": "Tool cannot make every line as drawn",
  "verdictCard.error": "Error",
  "verdictCard.shortfall": "Shortfall",
  "verdictCard.note": "Note",
  "verdictCard.ofTheCutLinesCannot":
    "{unreachedLength} of the cut lines cannot be reached by the tool. They lie up to {unreachedDistance} from the cut.",
  "verdictCard.inSlitsBecomeAsWide":
    "{slitPlaces, plural, one {# slit is} other {# slits are}} cut as wide as the tool, over {slitLength}.",
  "verdictCard.inPlacesCannotBeReached":
    "{unreached} in {unreachedPlaces, plural, one {# place} other {# places}} cannot be reached by the tool and stay uncut.",
  "verdictCard.liftingTheToolOnlyAs":
    "Lifting the tool only as high as needed between cuts saves {retracted} ({share, number} %).",
  "verdictCard.largestDeviationFromTheDrawing": "Largest deviation from the drawing",
  "verdictCard.isTheLargestAllowedDeviation": "{tolerance} is the largest allowed deviation",
  "verdictCard.acceptedBy": "Accepted by {by}: {reason}",
  "verdictCard.edge": "Edge {edge}",
  "verdictCard.programLine": "program line {line}",
  // panels/job/WaitsAtMachine.tsx
  "waitsAtMachine.theOperatorStatesThereWhen":
    "The operator confirms there when the machine has finished.",
  "waitsAtMachine.copyOfIsFinishedThe":
    "Copy {copiesDone, number} of {copies, number} is finished. The next one needs a new sheet.",
  "waitsAtMachine.tableBoardAndToolsAre": "The operator checks table, board and tools there first.",
  "waitsAtMachine.theJobIsPausedAnd": "The job is paused. The operator resumes it there.",
  "waitsAtMachine.waitsForTheOperatorAt": "Waits for the operator at {machine}.",
  "waitsAtMachine.boardOnTheTable": "Board on the table",
  "waitsAtMachine.sheet": "Sheet {sheet}",
  "waitsAtMachine.copyOf": "copy {copiesDone, number} of {copies, number}",
  "waitsAtMachine.toolsInTheStations": "Tools in the stations",
  "waitsAtMachine.stationOf": "Station of {machine}",
  // panels/library/CalibrationForm.tsx
  "calibrationForm.directionOfTravel": "Direction of travel (°)",
  "calibrationForm.offsetInXMm": "Offset in X (mm)",
  "calibrationForm.offsetInYMm": "Offset in Y (mm)",
  "calibrationForm.noMachineHasACutter":
    "No machine has a cutter, so there is nothing to calibrate.",
  "calibrationForm.computeTheDeflectionFromA": "Compute the deflection from a test cut",
  "calibrationForm.cutAContourWithoutCompensation":
    "Cut a contour without compensation. Measure how far the cut contour lies from the drawn one, on edges along X, along Y and at 45°.",
  "calibrationForm.cutter": "Cutter",
  "calibrationForm.sideOfTheContourOn": "Side of the contour on which the cutter ran",
  "calibrationForm.leftAsInProgramsOf": "Left, as in programs of knifetip",
  "calibrationForm.right": "Right",
  "calibrationForm.ofPoint": "{label} of point {at, number}",
  "calibrationForm.addPoint": "Add point",
  "calibrationForm.compute": "Compute",
  "calibrationForm.mmInXMmIn":
    "Deflection of {tool}: {x} mm in X, {y} mm in Y. The measured points differ from it by at most {residual} mm.",
  "calibrationForm.useTheseValues": "Use these values",
  // panels/library/ConflictCard.tsx
  "conflictCard.version": "Version {version}",
  "conflictCard.yours": "Yours",
  "conflictCard.discardMyChangesAndLoad": "Discard my changes and load version {version}",
  "conflictCard.saveMyChangesAsVersion": "Save my changes as version {version}",
  "conflictCard.anotherUser": "Another user",
  "conflictCard.hasSavedVersionSinceYou":
    "{by} has saved version {version} since you began. Your changes are not saved.",
  // panels/library/CopyForm.tsx
  "copyForm.giveItAName": "Give it a name.",
  "copyForm.aNameHasSmallLetters": "A name has small letters, digits, hyphens and underscores.",
  "copyForm.thereIsAWithThis":
    "There is a {shelf, select, machines {machine} boards {board} other {tool}} with this name. Choose another name.",
  "copyForm.copiedFrom": "copied from {title}",
  "copyForm.copy": "Copy {title}",
  "copyForm.titleOfTheCopy": "Title of the copy",
  "copyForm.asItIsShownIn": "As it is shown in lists",
  "copyForm.giveItATitle": "Give it a title.",
  "copyForm.nameOfTheCopy": "Name of the copy",
  "copyForm.forGatewaysFilesAndRequests":
    "Identifies the copy in files and requests. It cannot be changed later.",
  "copyForm.makeTheCopy": "Make the copy",
  "copyForm.cancel": "Cancel",
  // panels/library/DefinitionEditor.tsx
  "definitionEditor.loading": "Loading …",
  "definitionEditor.allFaults": "Show all corrections",
  "definitionEditor.notSavedValuesNeedA":
    "Not saved. {count, plural, one {# value needs} other {# values need}} a correction; each is marked in the form.",
  "definitionEditor.allEntries": "All entries",
  "definitionEditor.suppliedWithKnifetip": "supplied with knifetip",
  "definitionEditor.version": "version {version}",
  "definitionEditor.copy": "Copy",
  "definitionEditor.downloadToml": "Download TOML",
  "definitionEditor.deleteNow": "Delete now",
  "definitionEditor.delete": "Delete",
  "definitionEditor.thisEntryIsReadOnly": "This entry is read-only. Copy it to change it.",
  "definitionEditor.more": "More",
  "definitionEditor.save": "Save",
  "definitionEditor.whatIsChangedAndWhy": "What is changed, and why",
  "definitionEditor.saveAsVersion": "Save as version {version}",
  // panels/library/DefinitionForm.tsx
  "definitionForm.thisControllerLanguageHasNo": "This controller language has no settings.",
  "definitionForm.theSettingsOfThisController":
    "The settings of this controller language can be changed in the TOML file.",
  "definitionForm.name": "Name",
  "definitionForm.none": "{label}: none",
  "definitionForm.add": "Add: {label}",
  "definitionForm.remove": "Remove: {label}",
  "definitionForm.remove2": "Remove {word} {at, number}",
  "definitionForm.add2": "Add {word}",
  "definitionForm.remove3": "Remove {key}",
  "definitionForm.add3": "Add",
  // panels/library/DefinitionHistory.tsx
  "definitionHistory.versions": "Versions",
  "definitionHistory.compare": "Compare",
  "definitionHistory.version": "Version {compared}",
  "definitionHistory.version2": "Version {version}",
  // panels/library/DifferenceTable.tsx
  "differenceTable.field": "Field",
  // panels/library/ToolPicker.tsx
  "toolPicker.takeAToolFromThe": "Take a tool from the library",
  "toolPicker.itsDimensionsAndFeedRates":
    "Its dimensions and feed rates are copied into this station.",
  "toolPicker.chooseATool": "Choose a tool",
  // panels/order/BoardSelect.tsx
  "boardSelect.board": "Board",
  "boardSelect.asInTheLastJob": "As in the last job of this drawing",
  "boardSelect.chooseTheBoard": "Choose the board",
  "boardSelect.asLastTimeFor": "As last time for {customer}: {title}",
  // panels/order/CornersForm.tsx
  "cornersForm.automatic": "Automatic",
  "cornersForm.arcB": "Arc (B)",
  "cornersForm.straightWithStopC": "Straight with stop (C)",
  "cornersForm.blendD": "Blend (D)",
  "cornersForm.forEachCornerKnifetipChooses":
    "For each corner, knifetip chooses the path that takes the least time.",
  "cornersForm.theCentreOfTheTool":
    "The centre of the tool follows an arc around the corner, so the tool touches the corner all the time.",
  "cornersForm.theCentreOfTheTool2":
    "The centre of the tool moves straight past the corner, stops, and continues in the new direction.",
  "cornersForm.theCentreOfTheTool3":
    "The centre of the tool moves straight past the corner and changes direction on a small arc, without a stop.",
  "cornersForm.parameterKOfTheTool":
    "Parameter k of the tool path at the corner (0 = arc as in type B, 1 = straight with a stop as in type C)",
  "cornersForm.toolPathAtOuterCorners": "Tool path at outer corners",
  "cornersForm.whereTheToolIsToo": "Where the tool is too wide for a part of the contour",
  "cornersForm.leaveThisPartUncut": "Leave this part uncut",
  "cornersForm.doNotCreateAProgram": "Do not create a program",
  "cornersForm.inTheDrawingClickA":
    "In the drawing, click a cut near the corner whose tool path you want to choose.",
  "cornersForm.finishChoosingCorners": "Finish choosing corners",
  "cornersForm.chooseThePathForIndividual": "Choose the path for individual corners",
  "cornersForm.toolPathAtTheCorner": "Tool path at the corner at {one}",
  "cornersForm.resetTheToolPathAt": "Reset the tool path at the corner at {one}",
  "cornersForm.position": "{x}, {y} mm",
  // panels/order/CustomerField.tsx
  "customerField.customer": "Customer",
  "customerField.answersAreRememberedForEach": "Answers are remembered for each customer",
  // panels/order/OrderDetails.tsx
  "orderDetails.overdueSince": "overdue since {due}",
  "orderDetails.due": "due {due}",
  // panels/order/OrderDetailsForm.tsx
  "orderDetailsForm.orderDetails": "Order details: {externalId}",
  "orderDetailsForm.orderDetails2": "Order details",
  "orderDetailsForm.orderNumber": "Order number",
  "orderDetailsForm.customer": "Customer",
  "orderDetailsForm.due": "Due",
  "orderDetailsForm.notes": "Notes",
  // panels/order/OrderPanel.tsx
  "orderPanel.answerOtherFirst":
    "{open, plural, one {Answer the open question first.} other {Answer the # open questions first.}}",
  "orderPanel.chooseTheBoard": "Choose the board.",
  "orderPanel.chooseAMachine": "Choose a machine.",
  "orderPanel.newJob": "New job",
  "orderPanel.machine": "Machine",
  "orderPanel.chooseAMachine2": "Choose a machine",
  "orderPanel.leastLiftInTurnsMm":
    "Lift tools only {turnClearance, number, ::group-off} mm above the board to turn them",
  "orderPanel.savesTimeOnlyForBoard": "Saves time. Only for board that lies flat on the table.",
  "option.on": "Yes",
  "option.off": "No",
  "orderPanel.copies": "Copies",
  "orderPanel.prepareProgram": "Prepare program",
  "orderPanel.prepareAgain": "Prepare again",
  // panels/order/EdgeOptions.tsx: options of edges, by the names of options and fields
  "edgeOption.forTheNextJob": "For the next job of this drawing:",
  "edgeOption.selectedEdges": "{n, plural, one {This edge} other {These # edges}}",
  "edgeOption.allOfType": "All of type {type}",
  "edgeOption.fromStart": "{share} of the edge, {length} mm from its start",
  "edgeOption.asUsual": "Default",
  "edgeOption.millimetres": "{value} mm",
  "edgeOption.choicesForEdges": "Choices for edges",
  "edgeOption.edges": "{n, plural, one {Edge {edge}} other {# edges}}",
  "edgeOption.remove": "Remove: {subject}",
  // panels/order/SheetForm.tsx
  "sheetForm.largerThanTheDrawing": "Larger than the drawing",
  "sheetForm.cutToTheOutlineOf": "Cut to the outline of the drawing",
  "sheetForm.cutToARectangle": "Cut to a rectangle",
  "sheetForm.widthMm": "Width (mm)",
  "sheetForm.heightMm": "Height (mm)",
  "sheetForm.marginMm": "Margin (mm)",
  "sheetForm.sheet": "Sheet",
  "sheetForm.theDrawingWithItsMargin":
    "The drawing with its margin does not fit on the sheet: it needs {width}.",
  "sheetForm.besideTheSheetToolsTurn":
    "Beside the sheet, tools turn without being lifted. Load only a sheet that was cut to this outline.",
  "sheetForm.besideTheSheetToolsTurn2":
    "Beside the sheet, tools turn without being lifted. The margin is the distance of the drawing from the left and lower edge of the sheet. Load only a sheet of this size.",
  // panels/shared/LanguageMenu.tsx
  "languageMenu.language": "Language",
  // panels/shared/NotificationList.tsx
  "notificationList.showEdgesInTheDrawing":
    "Show {rows, plural, one {# edge} other {# edges}} in the drawing",
  "notificationList.closeThisMessage": "Close this message",
  // panels/shared/ProgressOverlay.tsx
  "progressOverlay.waitingForTheServer": "Waiting for the server",
  "progressOverlay.uploaded": "{fraction, number} % uploaded",
  "progressOverlay.readingTheFile": "Reading the file …",
  "progressOverlay.uploadOf": "Upload of {name}",
  // panels/shared/ShortcutsDialog.tsx
  "shortcutsDialog.showTheWholeDrawing": "Show the whole drawing",
  "shortcutsDialog.shiftF": "Shift F",
  "shortcutsDialog.showTheWholeTable": "Show the whole table",
  "shortcutsDialog.zoomInZoomOut": "Zoom in; zoom out",
  "shortcutsDialog.arrowKeys": "Arrow keys",
  "shortcutsDialog.moveTheView": "Move the view",
  "shortcutsDialog.ctrlZ": "Ctrl Z",
  "shortcutsDialog.undoTheLastChange": "Undo the last change",
  "shortcutsDialog.ctrlShiftZ": "Ctrl Shift Z",
  "shortcutsDialog.redoTheUndoneChange": "Redo the undone change",
  "shortcutsDialog.esc": "Esc",
  "shortcutsDialog.clearTheSelectionOfEdges": "Clear the selection of edges",
  "shortcutsDialog.ctrlA": "Ctrl A",
  "shortcutsDialog.selectAllEdges": "Select all edges",
  "shortcutsDialog.showOrHideTheLeft": "Show or hide the left panel; the right panel",
  "shortcutsDialog.showOrHideDrawingHead":
    "Show or hide drawing; head path; path of tool tip; moves above board",
  "shortcutsDialog.showOrHideToolWidth":
    "Show or hide tool width; points where a tool enters or leaves the board",
  "shortcutsDialog.changeWhatTheColoursShow":
    "Change what the colours show: line type, deviation or overcut",
  "shortcutsDialog.showOrHideThisList": "Show or hide this list",
  "shortcutsDialog.wheel": "Wheel",
  "shortcutsDialog.zoomAtTheCursor": "Zoom at the cursor",
  "shortcutsDialog.drag": "Drag",
  "shortcutsDialog.click": "Click",
  "shortcutsDialog.selectAnEdgeWithShift": "Select an edge; with Shift, add it to the selection",
  "shortcutsDialog.shiftDrag": "Shift drag",
  "shortcutsDialog.selectTheEdgesInA": "Select the edges in a box",
  "shortcutsDialog.keyboardAndMouseShortcuts": "Keyboard and mouse shortcuts",
  "shortcutsDialog.setTheLineTypeOf": "Set the line type of the selected edges",
  // panels/shared/ShowMore.tsx
  "showMore.showMoreEntriesLeft": "Show more entries ({left, number} left)",
  "showMore.showMoreEntries": "Show more entries",
  // panels/shared/labels.ts
  "labels.useTheLineTypeThat": "Use the line type that the profile gives",
  "labels.showTheseEdgesInThe": "Show these edges in the drawing",
  "labels.backToAllDrawings": "Back to all drawings",
  // panels/station/DryRunPanel.tsx
  "dryRunPanel.movesAlongTheWholeProgram":
    "Moves along the whole program above the board. Nothing is lowered or switched on.",
  "dryRunPanel.movesOnceRoundTheSheet":
    "Moves once round the sheet, or round all lines of the program, above the board.",
  "dryRunPanel.beforeTheStart": "Before the start",
  "dryRunPanel.tryItAboveTheBoard": "Try the program above the board first",
  "dryRunPanel.speedOfTheDryRun": "Speed of the dry run",
  "dryRunPanel.begin": "Start {kind}",
  "dryRunPanel.progress": "Progress: {kind}",
  "dryRunPanel.left": "<b>{secondsLeft}</b> left",
  "dryRunPanel.progressOfTheRunAbove": "Progress of the run above the board",
  "dryRunPanel.pathOfStationAboveThe":
    "Path of station {number}, {name}. Above the board, nothing is cut. The job keeps waiting for its start.",
  "dryRunPanel.aboveTheBoardNothingIs":
    "Above the board, nothing is cut. The job keeps waiting for its start.",
  "dryRunPanel.done": "{run} has ended. If the path was right, check and start the job.",
  "dryRunPanel.stopped": "{run} was stopped. The tool is lifted.",
  "dryRunPanel.failed": "{run} has failed.",
  // panels/station/FeedOverride.tsx
  "feedOverride.feed2": "Feed {percent, number} %",
  "feedOverride.feedOfTheProgram": "Feed <b>{percent} %</b> of the program",
  // panels/station/HandsClearButton.tsx
  "handsClearButton.countsForSMoreOr":
    "Valid for {left, number} s more, or until the machine has moved.",
  "handsClearButton.lookThatNobodyReachesInto":
    "Check that nobody reaches into the machine, then press. Valid for 60 s.",
  "handsClearButton.handsClear": "Hands clear",
  // panels/station/JogPad.tsx
  "jogPad.to": "{axis} {travel, number, ::group-off} to {travel2, number, ::group-off}{axis2}",
  "jogPad.longestMoveOfOneHold": "Longest move per press (mm, °)",
  "jogPad.free": "No limit",
  "jogPad.thereIsNoConnectionTo": "There is no connection to the server.",
  "jogPad.holdAnArrowToMove": "Hold an arrow to move; the machine stops when you release it.",
  "jogPad.travel": "{reason} Travel: {machine}",
  "jogPad.isAtTheLimitOf": "{axis} is at the limit of its travel.",
  "jogPad.move": "Move {label}",
  "jogPad.stop": "Stop {axis}",
  "jogPad.whileHeld": "{label} while the button is held",
  "jogPad.whileHeldAtMost":
    "{label} while the button is held, at most {limit, number, ::group-off}{axis}",
  // panels/station/StationChecks.tsx
  "stationChecks.checkAtTheTableThen":
    "Check at the table, then start ({signed, number} of {groups, number})",
  "stationChecks.countsForSMore": "Valid for {left, number} s more",
  "stationChecks.countsFor60S": "Valid for 60 s",
  // panels/station/StationControls.tsx
  "stationControls.cancelTheJob": "Cancel the job?",
  "stationControls.theJobHasNotStarted":
    "The job has not started. It leaves the queue of the machine.",
  "stationControls.cancelJob": "Cancel job",
  "stationControls.keepJob": "Keep job",
  "stationControls.stop": "Stop",
  "stationControls.start": "Start",
  "stationControls.checkAndTickEverythingThat": "Check and tick everything in the list first.",
  "stationControls.hold": "Hold",
  "stationControls.noJobRuns": "No job runs.",
  "stationControls.thisMachineCannotBeHeld":
    "This machine cannot be held from here. Use its own controls.",
  "stationControls.hasFinished": "Machine has finished",
  "stationControls.resume": "Resume",
  "stationControls.thereIsNothingToStop": "There is nothing to stop.",
  "stationControls.jobControls": "Job controls",
  "stationControls.thereIsNoConnectionTo": "There is no connection to the server.",
  "stationControls.thisIsNotAnEmergency":
    "<b>This is not an emergency stop.</b> In danger, press the red emergency stop button on the machine.",
  // panels/station/StationHeader.tsx
  "stationHeader.noConnection": "No connection",
  "stationHeader.reported": "Last report: {station}",
  "stationHeader.noServer": "No server",
  "stationHeader.connected": "Connected",
  "stationHeader.noController": "No controller",
  "stationHeader.allDrawings": "All drawings",
  "stationHeader.positionOfTheAxes": "Position of the axes",
  // panels/station/StationJob.tsx
  "stationJob.job": "Job",
  "stationJob.copies": "{copies, plural, one {# copy} other {# copies}}",
  "stationJob.each": "{seconds} each",
  "stationJob.tryAgain": "Try again",
  "stationJob.theMachineChecksTheProgram":
    "The machine checks the program again. Nothing moves before you start it.",
  "stationJob.compileAgain": "Compile again",
  "stationJob.compileTheJobAgain": "Compile the job again",
  "stationJob.left": "<b>{secondsLeft}</b> left",
  "stationJob.copyOf": "copy <b>{copiesDone, number}</b> of {copies, number}",
  "stationJob.progressOfTheJobOn": "Progress of the job on the table",
  "stationJob.copiesFinishedTheTableIs":
    "{copies, plural, one {# copy} other {# copies}} finished. The table is free for the next job.",
  "stationJob.theJobWasCancelled": "The job was cancelled.",
  "stationJob.queueAgainFromTheStart": "Queue again from the start",
  "stationJob.needsANewSheetThe": "Needs a new sheet: the whole copy is cut again.",
  "stationJob.itIsFinished": "Job is finished",
  "stationJob.onlyIfAllSheetsAre": "Only if all sheets are completely cut.",
  "stationJob.boardIsScrap": "Board is scrap",
  "stationJob.endsTheJobRemoveThe": "Ends the job. Remove the board first.",
  "stationJob.queueTheJobAgainFrom": "Queue the job again from the start?",
  "stationJob.theSheetOnTheTable":
    "The sheet on the table cannot be used for it. Put a new sheet on the table before you start.",
  "stationJob.queueAgain": "Queue again",
  "stationJob.doNotQueue": "Do not queue",
  "stationJob.continueThisSheet": "Continue this sheet",
  "stationJob.thePictureShowsWhereThe":
    "The picture shows where the head stopped: line {line, number} of {lines, number}.",
  "stationJob.thePictureShowsWhereThe2":
    "The picture shows where the head stopped: line {line, number} of {lines, number}, {name} in use.",
  "stationJob.continueThisSheetLeft": "Continue this sheet, {tracks} left",
  // panels/station/StationNotices.tsx
  "stationNotices.lookAtTheHeadBefore":
    "Look at the head before it moves. When the machine is unlocked, homed or released, all outputs are switched off.",
  "stationNotices.itIsNotKnownWhich":
    "It is not known which outputs are on: a station may be down.",
  "stationNotices.settingsOfTheController": "Settings of the controller",
  "stationNotices.connectionToTheController": "Connection to the controller",
  "stationNotices.moreSettingsDiffer": "{rows, number} more settings differ",
  // panels/station/StationOperations.tsx
  "stationOperations.home": "Home",
  "stationOperations.findsTheZeroOfAll": "Finds the zero of all axes. The machine moves.",
  "stationOperations.park": "Park",
  "stationOperations.liftsTheToolAndMoves": "Lifts the tool and moves the head out of the way.",
  "stationOperations.setXYZeroHere": "Set X Y zero here",
  "stationOperations.programsThenBeginAtThis": "Programs then begin at this place of the table.",
  "stationOperations.setTheZeroOfX": "Set the zero of X and Y here?",
  "stationOperations.fromNowOnAllPrograms":
    "From now on all programs start from this point. To undo this, home the machine.",
  "stationOperations.setZeroHere": "Set zero here",
  "stationOperations.keepTheZero": "Keep the present zero",
  "stationOperations.unlock": "Unlock",
  "stationOperations.clearsAnAlarmWithoutHoming":
    "Clears an alarm without homing. The position may be wrong.",
  "stationOperations.thereIsNoConnectionTo":
    "There is no connection to the server, so the machine cannot be operated from this page.",
  "stationOperations.moveTheMachine": "Move the machine",
  "stationOperations.outputsByHandOnlyAt": "Outputs by hand, only at rest and with the tool lifted",
  "stationOperations.output": "Output {number}",
  "stationOperations.on": "On",
  "stationOperations.off": "Off",
  "stationOperations.notKnown": "Not known",
  "stationOperations.spindleAt": "{spindle} at {speed, number}",
  "stationOperations.spindleCounterClockwise": "{spindle}, counter-clockwise",
  "stationOperations.spindleAtCounterClockwise": "{spindle} at {speed, number}, counter-clockwise",
  "stationOperations.switchOff": "{name} off",
  "stationOperations.switchOn": "{name} on",
  "stationOperations.oscillation": "oscillation",
  "stationOperations.spindle": "spindle",
  // panels/station/ToolCheckPanel.tsx
  "toolCheckPanel.toolCheck": "Tool check",
  "toolCheckPanel.checkAToolAboveThe": "Check a tool above the board",
  "toolCheckPanel.moveAboveThePoint": "Move {name} above the point",
  "toolCheckPanel.pointOnTheTable": "Point on the table",
  "toolCheckPanel.tryTheCorrection": "Try the correction",
  "toolCheckPanel.moveAboveThePoint2": "Move above the point",
  "toolCheckPanel.thenLowersTheToolAlmost":
    "Then lowers the tool almost to the board, with its spindle off.",
  "toolCheckPanel.lift": "Lift",
  "toolCheckPanel.straightUpAllOutputsGo": "Lifts the tool straight up and switches all outputs off.",
  "toolCheckPanel.tool": "Tool",
  "toolCheckPanel.wear": "Wear of the tool",
  "toolCheckPanel.offset": "Offset of the station",
  "toolCheckPanel.saveTheOffsetOf": "Save the offset of {name}",
  "toolCheckPanel.isTheTipNotAbove":
    "Is the tip not above the point? Correct its offset by steps of",
  "toolCheckPanel.less": "{axis} less",
  "toolCheckPanel.more": "{axis} more",
  "toolCheckPanel.saveTheOffset": "Save the offset",
  "toolCheckPanel.toolIsRight": "Tool is right ✓",
  "toolCheckPanel.toolIsRight2": "Tool is right",
  // panels/station/WornTools.tsx
  "wornTools.otherToolsAreAtThe":
    "{worn, plural, one {A tool is} other {{worn, number} tools are}} at the end of the tool life",
  "wornTools.workedOfM": "{name}, worked {used} of {life} m",
  "wornTools.iHavePutANew": "I have put a new tool into station {station}",
  "wornTools.reasonRecorded": "Reason (recorded)",
  "wornTools.orStateWhyTheOther": "Or state why the other tool stays in use",
  "wornTools.orStateWhyTheTool": "Or state why the tool stays in use",
  // panels/station/toolText.ts
  "toolText.tipOffsetBesideHeadAxis": "sideways offset of the tip from the head axis",
  "toolText.bladeAngle": "blade angle",
  "toolText.bladeWidth": "blade width",
  "toolText.tipOffsetBehindHeadAxis": "tip offset behind head axis",
  "toolText.leastRadiusOfABend": "smallest radius of a bend",
  "toolText.toolRadius": "tool radius",
  "toolText.bladeTilt": "blade tilt",
  "toolText.toolWidth": "tool width",
  "toolText.knife": "Knife",
  "toolText.creaseWheel": "Crease wheel",
  "toolText.vCutter": "V-cutter",
  "toolText.cutter": "Cutter",
  "toolText.laser": "Laser",
  // panels/webhooks/DeliveryList.tsx
  "deliveryList.all": "All",
  "deliveryList.deliveries": "Deliveries",
  "deliveryList.stateOfTheDeliveries": "State of the deliveries",
  "deliveryList.sendAllFailedDeliveriesAgain": "Send all failed deliveries again",
  "deliveryList.nothingWasSentInThe": "Nothing was sent in the last 30 days.",
  "deliveryList.thereAreNoDeliveriesIn": "There are no deliveries in this state.",
  "deliveryList.test": "Test",
  "deliveryList.noAttemptIsCompleteYet": "No attempt is complete yet.",
  "deliveryList.emptyResponse": "(empty response)",
  "deliveryList.sendAgain": "Send again",
  "deliveryList.webhookId": "webhook-id <code>{id}</code>",
  // panels/webhooks/WebhookCard.tsx
  "webhookCard.sendATest": "Send a test",
  "webhookCard.deliveries": "Deliveries",
  "webhookCard.edit": "Edit",
  "webhookCard.replaceTheSecret": "Replace the secret",
  "webhookCard.switchOff": "Switch off",
  "webhookCard.switchOn": "Switch on",
  "webhookCard.delete": "Delete",
  "webhookCard.save": "Save",
  "webhookCard.deleteTheWebhook": "Delete the webhook?",
  "webhookCard.noMoreEventsAreSent":
    "No more events are sent to {url}, and its list of deliveries is deleted.",
  "webhookCard.keep": "Keep",
  "webhookCard.last": "Last: {eventType}, {created}. {last}",
  "webhookCard.alsoSignedWithTheOld": "Also signed with the old secret until {until}",
  "webhookCard.test": "Test: {data}",
  // panels/webhooks/WebhookForm.tsx
  "webhookForm.url": "URL",
  "webhookForm.description": "Description",
  "webhookForm.systemThatReceivesTheEvents": "System that receives the events",
  "webhookForm.events": "Events",
  "webhookForm.allEvents": "All events",
  "webhookForm.cancel": "Cancel",
  // panels/webhooks/WebhookSecret.tsx
  "webhookSecret.secretOfTheWebhook": "Secret of the webhook",
  "webhookSecret.requestsAreSignedWithBoth": "Requests are signed with both secrets until {until}.",
  "webhookSecret.copyTheSecretNowIt": "Copy the secret now. It cannot be shown again.",
  "webhookSecret.copied": "Copied",
  "webhookSecret.copy": "Copy",
  "webhookSecret.done": "Done",
  "webhookSecret.n24Hours": "24 hours",
  "webhookSecret.n1Hour": "1 hour",
  "webhookSecret.n7Days": "7 days",
  "webhookSecret.n0HoursTheOldSecret": "0 hours (the old secret was disclosed)",
  "webhookSecret.replaceTheSecret": "Replace the secret?",
  "webhookSecret.forTheChosenTimeRequests":
    "For the chosen time, requests are signed with both secrets, so that the receiver accepts them before and after you enter the new secret there. Older secrets become invalid now.",
  "webhookSecret.alsoSignWithTheOld": "Also sign with the old secret for",
  "webhookSecret.cancel": "Cancel",
  "webhookSecret.replaceTheSecret2": "Replace the secret",
  // state/accounts/accounts.ts
  "accounts.users": "users",
  "accounts.designersOperatorsAndAdministrators": "designers, operators and administrators",
  "accounts.operatorsAndAdministrators": "operators and administrators",
  "accounts.administrators": "administrators",
  "accounts.onlyCanDoThis": "Only {role} can do this. {me}",
  "accounts.thisDeviceIsPairedWith": "This device ({name}) is paired with {machines} only.",
  "accounts.youAreSignedInAs": "You are signed in as {name} ({scopes}).",
  "accounts.noScope": "no scope",
  "accounts.viewer": "viewer",
  "accounts.designer": "designer",
  "accounts.operator": "operator",
  "accounts.admin": "admin",
  // state/actions.ts
  "actions.page": "{name}, page {page}",
  "actions.theProfileWasChangedElsewhere": "The profile was changed elsewhere",
  "actions.anotherUserHasChangedThe":
    "Another user has changed the profile {title} since your change.",
  "actions.nothingWasUndoneOrRedone":
    "Nothing was undone or redone. Check the rules of the profile.",
  // state/drawing/colours.ts
  "colours.red": "red",
  "colours.yellow": "yellow",
  "colours.green": "green",
  "colours.cyan": "cyan",
  "colours.blue": "blue",
  "colours.magenta": "magenta",
  "colours.whiteOrBlack": "white or black",
  "colours.darkGrey": "dark grey",
  "colours.lightGrey": "light grey",
  // state/drawing/draft.ts
  "draft.newProfile": "New profile",
  "draft.isNotAColourEnter": "{wrong} is not a colour. Enter a number from 1 to 255 or #rrggbb.",
  // state/drawing/drawingSync.ts
  "drawingSync.yourChangeWasNotSaved":
    "Your change was not saved: the drawing was changed elsewhere",
  "drawingSync.theDrawingWasChangedElsewhere": "The drawing was changed elsewhere",
  "drawingSync.wasChangedByAnotherUser":
    "{name} was changed by another user or in another window: {before}.",
  "drawingSync.checkTheDrawingThenRepeat":
    "Check the drawing, then repeat your change if it is still needed.",
  "drawingSync.yourEarlierChangesCanNo": "Your earlier changes can no longer be undone.",
  // state/drawing/importReport.ts
  "importReport.allObjectsKept": "all objects kept",
  "importReport.dropped": "{many, number} dropped",
  "importReport.merged": "{many, number} merged",
  // state/drawing/inspect.ts
  "inspect.noRuleOfTheProfile":
    "no rule of the profile matches, and the shape of the edge does not show the line type",
  // state/drawing/learnedLooks.ts
  "learnedLooks.layersWithoutAMeaning": "Layers whose name suggests no line type",
  "learnedLooks.layer": "Layer {layer}",
  "learnedLooks.colour": "Colour {colour}",
  "learnedLooks.lineStyle": "line style {linetype}",
  "learnedLooks.lineWidthMm": "line width {lineWidth, number, ::group-off} mm",
  // state/drawing/palette.ts
  "palette.cut": "Cut",
  "palette.crease": "Crease",
  "palette.vGroove": "V-groove",
  "palette.perforation": "Perforation",
  "palette.halfCut": "Half-cut",
  "palette.combiCutCrease": "Combi (cut-crease)",
  "palette.ignored": "Ignored",
  "palette.undecided": "Undecided",
  // state/drawing/questions.ts
  "questions.layer": "Layer {layer}",
  "questions.noToolForTheseEdges": "No tool for these edges",
  "questions.edgesWithoutALineType": "Edges without a line type",
  "questions.colour": "Colour {colour}",
  "questions.lineStyles": "{count, plural, one {Line style} other {Line styles}} {names}",
  "questions.lineWidths": "{count, plural, one {Line width} other {Line widths}} {widths}",
  // state/drawing/remoteChanges.ts
  "remoteChanges.itsUnitIsNow": "its unit is now {unit}",
  "remoteChanges.itsProfileIsNow": "its profile is now {profile}",
  "remoteChanges.itsEdgesWereReadAgain": "its edges were read again from the file",
  "remoteChanges.edgesNowHaveAnotherLine":
    "{rows, plural, one {# edge now has another line type} other {# edges now have another line type}}",
  "remoteChanges.lineTypesUnitAndProfile": "line types, unit and profile are as before",
  "remoteChanges.unitUnknown": "unknown",
  // state/drawing/sizes.ts
  "sizes.millimetres": "Millimetres",
  "sizes.centimetres": "Centimetres",
  "sizes.metres": "Metres",
  "sizes.inches": "Inches",
  "sizes.feet": "Feet",
  "sizes.points172Inch": "Points (1/72 inch)",
  "sizes.pixels196Inch": "Pixels (1/96 inch)",
  "sizes.pixels190InchOld": "Pixels (1/90 inch, old Inkscape)",
  // state/drawing/verdictMap.ts
  "verdictMap.lineType": "Line type",
  "verdictMap.deviationFromDrawing": "Deviation from drawing",
  "verdictMap.overcutLength": "Overcut length",
  // state/format.ts
  "format.thinnest": "thinnest",
  "format.justNow": "just now",
  "format.minutesAgo": "{minutes, number} min ago",
  "format.hoursAgo": "{hours, number} h ago",
  // state/job/jobs.ts
  "jobs.waitingForProgram": "Waiting for program",
  "jobs.preparingProgram": "Preparing program",
  "jobs.readyToSend": "Ready to send",
  "jobs.queued": "Queued",
  "jobs.running": "Running",
  "jobs.paused": "Paused",
  "jobs.finished": "Finished",
  "jobs.refused": "Refused",
  "jobs.interrupted": "Interrupted",
  "jobs.boardScrapped": "Board scrapped",
  "jobs.continuedByAnotherJob": "Continued by another job",
  "jobs.cancelled": "Cancelled",
  "jobs.waitingForOperator": "Waiting for operator",
  "jobs.outOfDate": "Out of date",
  "jobs.waitingForNewSheet": "Waiting for new sheet",
  "jobs.hasTheMachineFinished": "Has the machine finished?",
  "jobs.cancelTheRunningJob": "Cancel the running job?",
  "jobs.theMachineStopsLiftsThe":
    "The machine stops, lifts the tool and releases its stations. The board on the table is probably unusable.",
  "jobs.cancelJob": "Cancel job",
  "jobs.doNotCancel": "Do not cancel",
  "jobs.endThisJobBecauseIts": "End this job because its board is scrap?",
  "jobs.removeTheBoardFromThe":
    "Remove the board from the table first. The job ends, and the table is free for the next job. Copies that are not made can be queued afterwards.",
  "jobs.endJobBoardIsScrap": "End job, board is scrap",
  "jobs.doNotEndJob": "Do not end job",
  "jobs.markThisJobAsFinished": "Mark this job as finished?",
  "jobs.markTheJobAsFinished":
    "Mark the job as finished only if {copies, plural, one {the sheet is} other {all # sheets are}} completely cut. The job ends as finished, and the table is free for the next job.",
  "jobs.markAsFinished": "Mark as finished",
  "jobs.doNotMarkAsFinished": "Do not mark as finished",
  // state/job/queue.ts
  "queue.urgent": "Urgent",
  "queue.high": "High",
  "queue.normal": "Normal",
  "queue.low": "Low",
  "queue.onHold": "on hold",
  "queue.startUnknown": "start unknown",
  "queue.in": "in {startsIn}",
  "queue.next": "next",
  // state/job/rest.ts
  "rest.andMore": "{numbers} and {more, number} more",
  "rest.and": "{low, number} and {high, number}",
  "rest.tracks": "{most, plural, one {# track} other {# tracks}}",
  "rest.tracksBetween": "{least, number} to {most, plural, one {# track} other {# tracks}}",
  "rest.copiesNotMade":
    "{count, plural, one {# copy of the batch is} other {# copies of the batch are}} not made. Continue or scrap this sheet first, then queue the other copies here.",
  "rest.copiesNotQueued":
    "{count, plural, one {# copy of the batch is} other {# copies of the batch are}} neither made nor queued. Each needs a new sheet.",
  // state/job/stages.ts
  "stages.readingTheDrawing": "Reading the drawing",
  "stages.removingDuplicateLinesAndClosing": "Removing duplicate lines and closing gaps",
  "stages.assigningToolsToCutsAnd": "Assigning tools to cuts and creases",
  "stages.calculatingToolPaths": "Calculating tool paths",
  "stages.choosingTheOrderOfThe": "Choosing the order of the cuts",
  "stages.writingTheProgram": "Writing the program",
  "stages.checkingTheProgram": "Checking the program",
  "stages.waitingForTheServerTo": "Waiting for the server to begin",
  "stages.waitingForTheServerTo2": "Waiting for the server to finish its first start",
  "stages.programIsReady": "Program is ready",
  // state/library/definitions.ts
  "definitions.machines": "Machines",
  "definitions.boards": "Boards",
  "definitions.tools": "Tools",
  // state/notifications.ts
  "notifications.errorInThisPage": "Error in this page",
  "notifications.reloadThePageAndRepeat": "Reload the page and repeat the last step.",
  // state/order/sheet.ts
  "sheet.cutToTheOutlineOf": "cut to the outline of the drawing",
  "sheet.mmDrawingMmFromIts":
    "{size, number, ::group-off} × {size2, number, ::group-off} mm, drawing {margin, number, ::group-off} mm from its left and lower edge",
  // state/station/checkGroups.ts
  "checkGroups.boardAndSheet": "Board and sheet",
  "checkGroups.tools": "Tools",
  "checkGroups.tableAndHands": "Table and hands",
  // state/station/checks.ts
  "checks.itHasWorkedM": "The tool has worked along {used} m of lines",
  "checks.itHasWorkedOfM": "The tool has worked {used} of {life} m of its life",
  "checks.itsLifeIsUsedUp": "{worn}: its life is used up, change it",
  "checks.changeItSoon": "{worn}: change it soon",
  "checks.theDrawingNeeds": "The drawing needs {right}",
  // state/station/handsClear.ts
  "handsClear.stateFirstThatHandsAre": "Confirm first that all hands are clear of the machine.",
  "handsClear.handsClear": "Hands clear",
  "handsClear.takeBackHandsClear": "Withdraw “Hands clear”",
  // state/station/operations.ts
  "operations.start": "Start",
  "operations.theMachineHasNotReacted": "The machine has not reacted for {prompt, number} s.",
  "operations.ifItMustStopNow": "If it must stop now, press its emergency stop.",
  // state/station/station.ts
  "stationState.controllerNotConnected": "Controller not connected",
  "stationState.atRest": "At rest",
  "stationState.moving": "Moving",
  "stationState.held": "On hold",
  "stationState.movingByHand": "Moving by hand",
  "stationState.homing": "Homing",
  "stationState.checkMode": "Check mode",
  "stationState.safetyDoorOpen": "Safety door open",
  "stationState.alarm": "Alarm",
  "stationState.asleep": "In sleep mode",
  "stationState.waitsForATool": "Waits for a tool",
  "stationState.busy": "Busy",
  "stationState.connected": "Connected",
  "stationState.dryRun": "Dry run",
  "stationState.frame": "Frame",
  "stationState.toolCheck": "Tool check",
  "stationState.connecting": "Connecting",
  "stationState.machineNotConnected": "Machine not connected",
  "stationState.paused": "{title} paused",
  "stationState.sAgo": "{age, number} s ago",
  "stationState.theStateOfTheMachine": "The state of the machine is not known yet.",
  "stationState.theMachineIsNotConnected": "The machine is not connected.",
  "stationState.theControllerOfTheMachine": "The controller of the machine is not connected.",
  "stationState.aJobIsOnThis": "A job is on this machine. Stop it first.",
  "stationState.aJobIsHeldOn": "A job is held on this machine. Resume or stop it first.",
  "stationState.aJobRunsOnThis": "A job runs on this machine. Wait until it has ended, or stop it.",
  "stationState.theControllerOfThisMachine": "The controller of this machine cannot do this.",
  "stationState.nothingRuns": "No program runs.",
  "stationState.nothingIsHeld": "No program is on hold.",
  "stationState.theMachineRunsAboveThe":
    "The machine is making a dry run above the board. Wait until it has ended, or stop it.",
  "stationState.thereIsNoAlarm": "There is no alarm.",
  "stationState.closeTheSafetyDoorFirst": "Close the safety door first.",
  "stationState.anAlarmLocksTheMachine":
    "An alarm locks the machine. Home it, or unlock it, first.",
  "stationState.theMachineIsNotFree": "The machine is not free. Release it first.",
  "stationState.theMachineMovesWaitUntil": "The machine moves. Wait until it is at rest.",
  "stationState.theToolIsDownRaise":
    "The tool is down. Raise Z to {machine, number, ::group-off} mm first.",
  "stationState.sending": "sending",
  "stationState.acceptedWaitingForTheMachine": "accepted, waiting for the machine",
  "stationState.done": "done",
  "stationState.refused": "refused",
  "stationState.expiredNothingWasDone": "expired, nothing was done",
  // state/station/toolCheck.ts
  "toolCheck.lowerLeftCorner": "Lower left corner",
  "toolCheck.besideIt": "Beside the sheet",
  "toolCheck.upperRightCorner": "Upper right corner",
  "toolCheck.ifTheOffsetOfA":
    "If the offset of a station was corrected, copy the new tool table to LinuxCNC first.",
  "toolCheck.forTheNewestVersionOf":
    "Prepares the program again for the newest version of machine and board.",
  "toolCheck.theMachineCannotBeChanged": "The machine cannot be changed",
  "toolCheck.belongsToTheLibraryAnd": "{title} belongs to the library and cannot be changed.",
  "toolCheck.copyItUnderAName":
    "Copy it under a name of its own in the library, let the gateway use the copy, and check again.",
  "toolCheck.datumOfStationAfterA": "Datum of station {station} after a tool check",
  // state/station/wayOut.ts
  "wayOut.home": "Home",
  "wayOut.findsTheZeroOfAll": "Finds the zero of all axes. The machine moves.",
  "wayOut.unlock": "Unlock",
  "wayOut.clearsTheAlarmWithoutHoming":
    "Clears the alarm without homing. The position may be wrong.",
  "wayOut.switchesTheMachineOnIt": "Switches the machine on. It may have to be homed afterwards.",
  "wayOut.release": "Release",
  "wayOut.discardsWhatTheMachineHolds":
    "Discards the rest of the program that is on hold. No axis moves; the stations are raised.",
  "wayOut.alarm": "Alarm",
  "wayOut.theJobDoesNotMove": "The job cannot continue",
  "wayOut.theMachineTakesNoJob": "The machine cannot take a job",
  "wayOut.thereIsNoJobFor": "There is no job for this machine.",
  "wayOut.theMachineRunsAboveThe":
    "The machine is making a dry run above the board. Wait until it has ended, or stop it.",
  "wayOut.noJobWaitsForIts": "No job waits for its start.",
  "wayOut.noJobIsHeld": "No job is held.",
  "wayOut.closeTheSafetyDoorFirst": "Close the safety door first.",
  // state/webhooks/webhooks.ts
  "webhookTexts.jobReceived": "Job received",
  "webhookTexts.jobCompiling": "Job compiling",
  "webhookTexts.jobReady": "Job ready",
  "webhookTexts.jobQueued": "Job queued",
  "webhookTexts.jobRunning": "Job running",
  "webhookTexts.jobHeld": "Job held",
  "webhookTexts.jobFinished": "Job finished",
  "webhookTexts.jobRefused": "Job refused",
  "webhookTexts.jobInterrupted": "Job interrupted",
  "webhookTexts.boardScrapped": "Board scrapped",
  "webhookTexts.jobContinuedByAnotherJob": "Job continued by another job",
  "webhookTexts.jobCancelled": "Job cancelled",
  "webhookTexts.otherChangeOfAJob": "Other change of a job",
  "webhookTexts.drawingUploaded": "Drawing uploaded",
  "webhookTexts.drawingChanged": "Drawing changed",
  "webhookTexts.drawingDeleted": "Drawing deleted",
  "webhookTexts.waiting": "Waiting",
  "webhookTexts.delivered": "Delivered",
  "webhookTexts.failed": "Failed",
  "webhookTexts.allEvents": "All events",
  "webhookTexts.ms": "{seconds, number} ms",
  "webhookTexts.noAnswer": "No answer",
  "webhookTexts.status": "Status {status}",
  "webhookTexts.notSentYet": "Not sent yet",
  "webhookTexts.after": "{attempt} after {seconds}",
  "webhookTexts.delivered2": "Delivered: {result}",
  "webhookTexts.failed2": "Failed: {result}",
  "webhookTexts.nextAttempt": "{result}; next attempt {next}",
  "webhookTexts.switchedOff": "Switched off",
  "webhookTexts.pausedUntilAfterFailedAttempts":
    "Paused until {paused} after {failures, number} failed attempts",
  "webhookTexts.theLastAttemptFailed": "The last attempt failed",
  "webhookTexts.failedAttempts": "{failures, number} failed attempts",
  "webhookTexts.nothingSentYet": "Nothing sent yet",
  "webhookTexts.working": "Working",
  "webhookTexts.s": "{seconds} s",
} as const;
