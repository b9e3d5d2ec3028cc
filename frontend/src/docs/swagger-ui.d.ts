/** The part of Swagger UI that is used here; the package has no types. */
declare module "swagger-ui-dist/swagger-ui-es-bundle.js" {
  interface Request {
    headers: Record<string, string>;
  }
  interface Options {
    readonly dom_id: string;
    readonly url: string;
    readonly deepLinking: boolean;
    readonly docExpansion: "list" | "full" | "none";
    readonly defaultModelsExpandDepth: number;
    readonly validatorUrl: string | null;
    readonly requestInterceptor: (request: Request) => Request;
  }
  export default function SwaggerUI(options: Options): void;
}
