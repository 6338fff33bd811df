import { apiVersion } from 'slicecast';

document.documentElement.dataset.apiVersion = apiVersion;
