// The worker of the region's page.

import init from "../../pkg/index.js";
import { serveJobs } from "../common/serve.js";
import { RegionPipeline } from "./pipeline.js";

serveJobs(new RegionPipeline(), init);
