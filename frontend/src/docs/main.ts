/** The description of the REST API, shown by Swagger UI from this server without a network. */

import SwaggerUI from "swagger-ui-dist/swagger-ui-es-bundle.js";
import "swagger-ui-dist/swagger-ui.css";

SwaggerUI({
  dom_id: "#docs",
  url: "/api/v1/openapi.json",
  deepLinking: true,
  docExpansion: "list",
  defaultModelsExpandDepth: 0,
  // The validator is a service on the internet.
  validatorUrl: null,
  requestInterceptor: (request) => {
    request.headers["X-Knifetip"] = "docs";
    return request;
  },
});
